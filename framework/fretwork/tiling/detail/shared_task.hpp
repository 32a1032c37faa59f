// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>

#include <cstddef>
#include <mutex>
#include <string_view>

namespace fretwork::tiling::detail {

/// A long task that several threads share: whether it goes on, and how far it is. It comes in parts, whose
/// number nobody knows beforehand: each is a share of what is left. Its progress ends with the object.
class Work {
  public:
    Work(const base::Control& control, std::string_view task);
    ~Work();
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;

    [[nodiscard]] const base::Control& control() const { return control_; }
    /// Throws base::Stopped if the work is to stop.
    void check() const { control_.check(); }
    /// Start a part of at most `most_steps` steps, worth `share` of the remaining progress; single-threaded.
    void begin_part(std::size_t most_steps, double share);
    /// A step is done. Throws base::Stopped.
    void advance();
    /// All is done.
    void complete();

  private:
    void tell(double share);

    base::Control control_;
    std::mutex mutex_;
    std::size_t steps_ = 0;   // of the part
    std::size_t done_ = 0;    // of them
    double before_ = 0.0;     // share of the work that was done before the part
    double share_ = 0.0;      // of the part in what was left then
    double last_told_ = 0.0;  // share of the work
};

}  // namespace fretwork::tiling::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>

#include <cstddef>
#include <mutex>
#include <string_view>

namespace fretwork::tiling::detail {

/// A long task that several threads share: whether it is to go on, and how far it is. Its progress ends with
/// the object.
class Work {
  public:
    Work(const base::Control& control, std::string_view task, std::size_t steps);
    ~Work();
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;

    [[nodiscard]] const base::Control& control() const { return control_; }
    /// Throws base::Stopped if the work is to stop.
    void check() const { control_.check(); }
    /// So many steps are done, or turned out not to be needed. Throws base::Stopped.
    void advance(std::size_t steps);

  private:
    base::Control control_;
    std::mutex mutex_;
    std::size_t done_ = 0;
};

}  // namespace fretwork::tiling::detail

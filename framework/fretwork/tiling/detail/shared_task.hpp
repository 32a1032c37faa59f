// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/base/task.hpp>

#include <cstddef>
#include <mutex>
#include <string_view>

namespace fretwork::tiling::detail {

/// The stop and the progress of a long task that several threads share. The task has parts, whose number is
/// not known in advance, so each part is worth a share of the remaining progress. The destructor reports the
/// end of the task.
class SharedTask {
  public:
    SharedTask(const base::Control& control, std::string_view name);

    [[nodiscard]] const base::Control& control() const { return control_; }
    /// Throws base::Stopped if the caller has asked to stop.
    void check() const { control_.check(); }
    /// Start a part of usually at most `most_steps` steps, worth `share` of the remaining progress. No other
    /// thread may use the task during this call. Throws base::Stopped.
    void begin_part(std::size_t most_steps, double share);
    /// Count a step as done. Throws base::Stopped.
    void advance();
    /// Report that the whole task is done. Throws base::Stopped.
    void complete();

  private:
    void report(double share);

    base::Control control_;
    base::Task task_;
    std::mutex mutex_;
    std::size_t steps_ = 0;       // number of steps of the part
    std::size_t done_ = 0;        // number of these steps that are done
    double before_ = 0.0;         // share of the task that was done before the part
    double share_ = 0.0;          // share of the part in the progress that then remained
    double last_reported_ = 0.0;  // share of the task, as last reported
};

}  // namespace fretwork::tiling::detail

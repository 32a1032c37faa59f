// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>

#include <cstddef>
#include <mutex>
#include <string_view>

namespace fretwork::base {

/// A task in a scope: the constructor reports its start to the receiver of progress, and the destructor
/// reports its end, also after an exception.
class Task {
  public:
    /// Begin a task of `steps` steps, and report its start.
    Task(const Control& control, std::string_view name, std::size_t steps) : progress_(control.progress) {
        if (progress_ != nullptr) progress_->start(name, steps);
    }
    Task(const Task&) = delete;
    Task& operator=(const Task&) = delete;
    ~Task() {
        if (progress_ != nullptr) progress_->finish();
    }
    /// Report that `done` of the steps are done.
    void update(std::size_t done) const {
        if (progress_ != nullptr) progress_->update(done);
    }

  private:
    Progress* progress_;
};

/// A task whose steps end on any thread, in any order.
class ParallelTask {
  public:
    /// Begin a task of `steps` steps, and report its start.
    ParallelTask(const Control& control, std::string_view name, std::size_t steps)
        : task_(control, name, steps) {}
    /// Count one more step as done, and report the number of steps done.
    void advance() {
        const std::lock_guard lock(mutex_);
        task_.update(++done_);
    }

  private:
    Task task_;
    std::mutex mutex_;
    std::size_t done_ = 0;
};

}  // namespace fretwork::base

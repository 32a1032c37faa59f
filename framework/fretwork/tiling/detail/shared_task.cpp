// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/tiling/detail/shared_task.hpp>

#include <algorithm>

namespace fretwork::tiling::detail {
namespace {

constexpr std::size_t kTotal = 1000;       // number of steps of the reported progress
constexpr double kStepsUsuallyDone = 0.5;  // share of a part's largest number of steps

}  // namespace

SharedTask::SharedTask(const base::Control& control, std::string_view name)
    : control_(control), task_(control, name, kTotal) {}

void SharedTask::begin_part(std::size_t most_steps, double share) {
    check();
    before_ = last_reported_;
    share_ = share;
    steps_ = most_steps;
    done_ = 0;
}

void SharedTask::advance() {
    check();
    if (!control_.progress) return;
    const std::lock_guard lock(mutex_);
    ++done_;
    const double part =
        std::min(1.0, static_cast<double>(done_) / (kStepsUsuallyDone * static_cast<double>(steps_)));
    report(before_ + share_ * (1 - before_) * part);
}

void SharedTask::complete() {
    check();
    report(1.0);
}

void SharedTask::report(double share) {
    last_reported_ = share;
    task_.update(static_cast<std::size_t>(share * static_cast<double>(kTotal)));
}

}  // namespace fretwork::tiling::detail

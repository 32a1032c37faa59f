// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/tiling/detail/work.hpp>

#include <algorithm>

namespace fretwork::tiling::detail {
namespace {

constexpr std::size_t kTotal = 1000;       // the unit of the progress
constexpr double kStepsUsuallyDone = 0.5;  // of the most that a part may take

}  // namespace

Work::Work(const base::Control& control, std::string_view task) : control_(control) {
    if (control_.progress) control_.progress->start(task, kTotal);
}

Work::~Work() {
    if (control_.progress) control_.progress->finish();
}

void Work::begin_part(std::size_t most_steps, double share) {
    check();
    before_ = last_told_;
    share_ = share;
    steps_ = most_steps;
    done_ = 0;
}

void Work::advance() {
    check();
    if (!control_.progress) return;
    const std::lock_guard lock(mutex_);
    ++done_;
    const double part =
        std::min(1.0, static_cast<double>(done_) / (kStepsUsuallyDone * static_cast<double>(steps_)));
    tell(before_ + share_ * (1 - before_) * part);
}

void Work::complete() {
    check();
    if (control_.progress) tell(1.0);
}

void Work::tell(double share) {
    last_told_ = share;
    control_.progress->update(static_cast<std::size_t>(share * static_cast<double>(kTotal)));
}

}  // namespace fretwork::tiling::detail

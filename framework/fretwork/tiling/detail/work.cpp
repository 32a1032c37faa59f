// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/tiling/detail/work.hpp>

namespace fretwork::tiling::detail {

Work::Work(const base::Control& control, std::string_view task, std::size_t steps) : control_(control) {
    if (control_.progress) control_.progress->start(task, steps);
}

Work::~Work() {
    if (control_.progress) control_.progress->finish();
}

void Work::advance(std::size_t steps) {
    check();
    if (!control_.progress) return;
    const std::lock_guard lock(mutex_);
    done_ += steps;
    control_.progress->update(done_);
}

}  // namespace fretwork::tiling::detail

// SPDX-License-Identifier: GPL-3.0-or-later
// Long work that is asked to stop.
#pragma once

#include <fretwork/base/control.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace fretwork::test {

/// Asks work to stop at its n-th look, the first being 0, and at all after it.
class StopAtLook {
  public:
    explicit StopAtLook(std::size_t look = SIZE_MAX) : look_(look) {}
    StopAtLook(const StopAtLook&) = delete;
    StopAtLook& operator=(const StopAtLook&) = delete;

    [[nodiscard]] base::Control control() const { return {.question = &question_}; }
    [[nodiscard]] std::size_t looks() const { return looks_; }

  private:
    std::size_t look_;
    std::atomic<std::size_t> looks_{0};
    std::function<bool()> question_ = [this] { return looks_++ >= look_; };
};

/// Work stops at whichever look it is asked to, the first and the last among some that are tried.
/// @param work        called with a control; on one thread, so that looks have an order
/// @param after_stop  called after each stop: nothing is half-done
template <class Work, class AfterStop>
void expect_stops_at_any_look(const Work& work, const AfterStop& after_stop) {
    constexpr std::size_t kTried = 25;
    const StopAtLook never;
    work(never.control());
    const std::size_t looks = never.looks();
    ASSERT_GT(looks, 0U) << "the work never looks whether to stop";
    const std::size_t last = looks - 1;
    for (std::size_t i = 0; i <= std::min(kTried, last); ++i) {
        const StopAtLook stop(last * i / std::min(kTried, std::max<std::size_t>(last, 1)));
        EXPECT_THROW(work(stop.control()), base::Stopped) << "look " << stop.looks() << " of " << looks;
        after_stop();
    }
}

}  // namespace fretwork::test

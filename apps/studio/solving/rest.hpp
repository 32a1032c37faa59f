// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>

#include <chrono>
#include <thread>

namespace fretwork::studio {

/// Wait until no newer edit is expected: those of a stroke or drag follow each other faster. Throws Stopped.
inline void rest(const base::Control& control) {
    constexpr std::chrono::milliseconds kQuiet{300};
    constexpr std::chrono::milliseconds kLook{10};
    for (auto waited = 0 * kLook; waited < kQuiet; waited += kLook) {
        control.check();
        std::this_thread::sleep_for(kLook);
    }
}

}  // namespace fretwork::studio

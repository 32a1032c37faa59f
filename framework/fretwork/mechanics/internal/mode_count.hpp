// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/modes.hpp>

#include <string>

namespace fretwork::mechanics {

/// Refuse a number of modes below `least` or above kMostModes. `least` is 0 in options, where it means that
/// no modes are wanted.
inline void check_mode_count(int count, int least) {
    if (count < least || count > kMostModes)
        throw base::InputError("the number of modes is " + std::to_string(count) + ", where " +
                               std::to_string(least) + " to " + std::to_string(kMostModes) + " are possible");
}

}  // namespace fretwork::mechanics

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/pattern/pattern.hpp>

#include <chrono>
#include <cstdint>
#include <functional>
#include <vector>

namespace fretwork::studio {

/// The limits at which a count ends, because counting some layouts would take too long.
struct CountLimits {
    std::uint64_t patterns = 50'000'000;
    std::chrono::milliseconds time{20'000};
    std::size_t samples = 12;  ///< number drawn from the patterns found, each equally likely
};

/// Valid patterns of a layout.
struct CountedPatterns {
    std::uint64_t patterns = 0;
    bool is_complete = true;                  ///< false: a limit was met, and there are more
    std::vector<pattern::Pattern> samples{};  ///< some of them, in the order of pattern::for_each_pattern
};

/// Count the valid patterns of a layout, with the rules that `fretwork enumerate` has without options, and
/// draw some of them.
/// @param tell  called a few times a second with the number that is found by then; may be empty
/// Throws Stopped if the caller asks for it.
CountedPatterns counted(const pattern::NodeLayout& layout, const CountLimits& limits,
                        const base::Control& control, const std::function<void(std::uint64_t)>& tell);

}  // namespace fretwork::studio

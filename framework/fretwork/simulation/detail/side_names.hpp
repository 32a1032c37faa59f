// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/load_cases/load_case.hpp>

#include <array>

namespace fretwork::simulation::detail {

/// The names of the sides of a surface, in the order of Side.
inline constexpr std::array<const char*, 4> kSideNames = {"left", "right", "bottom", "top"};

inline const char* side_name(Side side) {
    return kSideNames[static_cast<std::size_t>(side)];
}

}  // namespace fretwork::simulation::detail

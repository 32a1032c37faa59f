// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>

namespace fretwork::tiling::detail {

/// SplitMix64 (Steele, Lea and Flood 2014): the same numbers on every machine.
class SplitMix64 {
  public:
    explicit SplitMix64(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15U;
        std::uint64_t mixed = state_;
        mixed = (mixed ^ (mixed >> 30U)) * 0xbf58476d1ce4e5b9U;
        mixed = (mixed ^ (mixed >> 27U)) * 0x94d049bb133111ebU;
        return mixed ^ (mixed >> 31U);
    }
    /// Each number below `count` with the same chance: what would favour small numbers is drawn again.
    std::uint64_t below(std::uint64_t count) {
        const std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
        const std::uint64_t limit = most - most % count;
        std::uint64_t drawn = next();
        while (drawn >= limit) drawn = next();
        return drawn % count;
    }
    /// From 0 to below 1, by the upper 53 bits.
    double share() { return static_cast<double>(next() >> 11U) * 0x1p-53; }

  private:
    std::uint64_t state_;
};

}  // namespace fretwork::tiling::detail

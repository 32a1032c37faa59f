// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/census.hpp>

#include <cstdint>

namespace fretwork::pattern::detail {

/// Random numbers that are the same on every system: SplitMix64 [Steele2014], one stream for each number.
class RandomStream {
  public:
    RandomStream(std::uint64_t seed, std::uint64_t stream) : state_(mix(mix(seed) ^ stream)) {}

    std::uint64_t next() { return mix(state_ += kGamma); }

    /// A whole number below `end`, each with the same probability. Pre: end > 0.
    GraphCount below(GraphCount end) {
        GraphCount mask = end - 1;
        for (int shift = 1; shift < 128; shift *= 2) mask |= mask >> shift;
        for (;;) {
            const GraphCount high = next();
            const GraphCount candidate = (high << 64 | next()) & mask;
            if (candidate < end) return candidate;
        }
    }

  private:
    static constexpr std::uint64_t kGamma = 0x9e3779b97f4a7c15;
    static constexpr std::uint64_t mix(std::uint64_t z) {
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }
    std::uint64_t state_;
};

}  // namespace fretwork::pattern::detail

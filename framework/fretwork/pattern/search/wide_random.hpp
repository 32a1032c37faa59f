// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/random.hpp>
#include <fretwork/pattern/census.hpp>

#include <cstdint>

namespace fretwork::pattern::detail {

/// Random integers as wide as counts of graphs (128 bits), in numbered streams.
class WideRandom {
  public:
    WideRandom(std::uint64_t seed, std::uint64_t stream)
        : random_(base::SplitMix64::mix(base::SplitMix64::mix(seed) ^ stream)) {}

    std::uint64_t next() { return random_.next(); }

    /// A uniform integer below `end`. Pre: end > 0.
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
    base::SplitMix64 random_;
};

}  // namespace fretwork::pattern::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>

namespace fretwork::base {

/// Philox4x32-10 of [Salmon2011]: ten rounds that turn a counter and a key into four random words.
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key);

/// A seed for the generator of another library in run number `run`.
std::uint32_t derived_seed(std::uint64_t seed, std::uint64_t run);

/// Counter-based random numbers: draw n of a stream depends on (seed, stream, n) alone. Only laplace() also
/// depends on the C library, in the rounding of its logarithm.
class RandomStream {
  public:
    /// Begin a stream. Streams of one seed are independent of each other.
    RandomStream(std::uint64_t seed, std::uint64_t stream) : seed_(seed), stream_(stream) {}

    /// A number distributed uniformly in the open interval (0, 1), with 52 random bits.
    double uniform();
    /// A number with the Laplace distribution of mean zero: the density is exp(-|x| / scale) / (2 scale).
    double laplace(double scale);

  private:
    std::uint64_t seed_;
    std::uint64_t stream_;
    std::uint64_t draws_ = 0;
};

/// SplitMix64 [Steele2014]: random integers that are the same on every machine.
class SplitMix64 {
  public:
    /// Begin a sequence.
    explicit SplitMix64(std::uint64_t seed) : state_(seed) {}

    /// The 64-bit hash of a number; different numbers have different hashes.
    static constexpr std::uint64_t mix(std::uint64_t number) {
        number = (number ^ (number >> 30U)) * 0xbf58476d1ce4e5b9U;
        number = (number ^ (number >> 27U)) * 0x94d049bb133111ebU;
        return number ^ (number >> 31U);
    }

    /// The next 64 bits.
    std::uint64_t next() { return mix(state_ += 0x9e3779b97f4a7c15U); }
    /// A uniform integer below `count`. Draws that would favour small numbers are rejected and repeated.
    std::uint64_t below(std::uint64_t count) {
        const std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
        const std::uint64_t limit = most - most % count;
        std::uint64_t drawn = next();
        while (drawn >= limit) drawn = next();
        return drawn % count;
    }
    /// A uniform number in [0, 1), made of the upper 53 bits of a draw.
    double share() { return static_cast<double>(next() >> 11U) * 0x1p-53; }

  private:
    std::uint64_t state_;
};

}  // namespace fretwork::base

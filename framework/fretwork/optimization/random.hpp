// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace fretwork::optimization {

/// Philox4x32-10 of [Salmon2011]: ten rounds that turn a counter and a key into four random words.
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key);

/// A seed for run number `run` of a generator that another library brings along.
std::uint32_t derived_seed(std::uint64_t seed, std::uint64_t run);

/// Counter-based random numbers: draw n of a stream depends on nothing but (seed, stream, n), and on no
/// standard library.
class RandomStream {
  public:
    /// Streams of one seed are independent of each other.
    RandomStream(std::uint64_t seed, std::uint64_t stream) : seed_(seed), stream_(stream) {}

    /// Uniform in the open interval (0, 1), with 52 random bits.
    double uniform();
    /// Laplace distributed with mean zero and density exp(-|x| / scale) / (2 scale).
    double laplace(double scale);

  private:
    std::uint64_t seed_;
    std::uint64_t stream_;
    std::uint64_t draws_ = 0;
};

}  // namespace fretwork::optimization

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/random.hpp>

#include <cmath>

namespace fretwork::base {
namespace {

constexpr std::uint32_t low_word(std::uint64_t value) {
    return static_cast<std::uint32_t>(value);
}
constexpr std::uint32_t high_word(std::uint64_t value) {
    return static_cast<std::uint32_t>(value >> 32U);
}

}  // namespace

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key) {
    constexpr int kRounds = 10;
    constexpr std::array<std::uint64_t, 2> kMultipliers = {0xD2511F53U, 0xCD9E8D57U};
    constexpr std::array<std::uint32_t, 2> kWeyl = {0x9E3779B9U, 0xBB67AE85U};
    for (int round = 0; round < kRounds; ++round) {
        const std::uint64_t product0 = kMultipliers[0] * counter[0];
        const std::uint64_t product1 = kMultipliers[1] * counter[2];
        counter = {high_word(product1) ^ counter[1] ^ key[0], low_word(product1),
                   high_word(product0) ^ counter[3] ^ key[1], low_word(product0)};
        key = {key[0] + kWeyl[0], key[1] + kWeyl[1]};
    }
    return counter;
}

std::uint32_t derived_seed(std::uint64_t seed, std::uint64_t run) {
    // A counter that no stream reaches: streams count draws in the first two words.
    constexpr std::uint32_t kBeyondAllDraws = 0xFFFF'FFFFU;
    return philox({kBeyondAllDraws, kBeyondAllDraws, low_word(run), high_word(run)},
                  {low_word(seed), high_word(seed)})[0];
}

double RandomStream::uniform() {
    const auto words = philox({low_word(draws_), high_word(draws_), low_word(stream_), high_word(stream_)},
                              {low_word(seed_), high_word(seed_)});
    ++draws_;
    // A number of 52 bits plus 0.5 is exact, so the result stays above 0 and below 1.
    const std::uint64_t bits = (std::uint64_t{words[0]} << 20U) ^ (words[1] >> 12U);
    return (static_cast<double>(bits) + 0.5) * 0x1p-52;
}

double RandomStream::laplace(double scale) {
    const double u = uniform() - 0.5;
    return u < 0.0 ? scale * std::log1p(2.0 * u) : -scale * std::log1p(-2.0 * u);
}

}  // namespace fretwork::base

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/pattern.hpp>

#include <bit>
#include <cstdint>

namespace fretwork::pattern::detail {

// A set of candidate edges as one unsigned integer, with a bit for each edge. The number of candidate edges
// of the layout decides whether 64 or 128 bits are needed.
// __extension__ because ISO C++ has no integer of 128 bits.
using Word64 = std::uint64_t;
__extension__ using Word128 = unsigned __int128;

inline int lowest_bit(Word64 word) {
    return std::countr_zero(word);
}
inline int lowest_bit(Word128 word) {
    const auto low = static_cast<Word64>(word);
    return low != 0 ? std::countr_zero(low) : 64 + std::countr_zero(static_cast<Word64>(word >> 64));
}
inline int bit_count(Word64 word) {
    return std::popcount(word);
}
inline int bit_count(Word128 word) {
    return std::popcount(static_cast<Word64>(word)) + std::popcount(static_cast<Word64>(word >> 64));
}

/// The set that holds one edge.
template <class Word>
Word single(std::size_t edge) {
    return static_cast<Word>(Word{1} << edge);
}

/// Call visit(edge) for every edge of a set, in ascending order.
template <class Word, class Visit>
void for_each_bit(Word word, const Visit& visit) {
    for (; word != 0; word &= word - 1) visit(lowest_bit(word));
}

template <class Word>
Word to_word(const Pattern::Bits& bits) {
    Word word = 0;
    for (std::size_t e = bits._Find_first(); e < bits.size(); e = bits._Find_next(e)) {
        word |= single<Word>(e);
    }
    return word;
}

template <class Word>
Pattern to_pattern(Word word) {
    Pattern::Bits bits;
    for_each_bit(word, [&](int edge) { bits.set(edge); });
    return Pattern(bits);
}

}  // namespace fretwork::pattern::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/detail/independent_sets.hpp>

#include <algorithm>
#include <utility>

namespace fretwork::pattern::detail {
namespace {

CountsBySize product(const CountsBySize& left, const CountsBySize& right) {
    CountsBySize result(left.size() + right.size() - 1);
    for (std::size_t i = 0; i < left.size(); ++i) {
        for (std::size_t j = 0; j < right.size(); ++j) result[i + j] += left[i] * right[j];
    }
    return result;
}

/// without + x with
CountsBySize sum(const CountsBySize& without, const CountsBySize& with) {
    CountsBySize result(std::max(without.size(), with.size() + 1));
    for (std::size_t i = 0; i < without.size(); ++i) result[i] += without[i];
    for (std::size_t i = 0; i < with.size(); ++i) result[i + 1] += with[i];
    return result;
}

GraphCount entry(const CountsBySize& counts, int size) {
    return size >= 0 && size < static_cast<int>(counts.size()) ? counts[static_cast<std::size_t>(size)] : 0;
}

}  // namespace

template <class Word>
std::size_t IndependentSets<Word>::WordHash::operator()(Word word) const {
    std::uint64_t hash = static_cast<std::uint64_t>(word) * 0x9e3779b97f4a7c15;
    if constexpr (sizeof(Word) > sizeof(std::uint64_t))
        hash ^= static_cast<std::uint64_t>(word >> 64) * 0xbf58476d1ce4e5b9;
    return static_cast<std::size_t>(hash ^ hash >> 32);
}

template <class Word>
IndependentSets<Word>::IndependentSets(std::vector<Word> conflicts, Word edges, std::size_t most_parts)
    : conflicts_(std::move(conflicts)), edges_(edges), most_parts_(most_parts) {
    for_each_bit(edges, [&](int edge) {
        if ((conflicts_[static_cast<std::size_t>(edge)] & single<Word>(edge)) != 0)
            edges_ &= ~single<Word>(edge);
    });
    counts_ = count(edges_);
}

/// The edges that chains of conflicts join with the lowest one.
template <class Word>
Word IndependentSets<Word>::part_of_lowest(Word edges) const {
    Word part = edges & (~edges + 1);
    for (Word front = part; front != 0;) {
        const Word fresh = conflicts_[static_cast<std::size_t>(lowest_bit(front))] & edges & ~part;
        part |= fresh;
        front = (front & (front - 1)) | fresh;
    }
    return part;
}

template <class Word>
int IndependentSets<Word>::most_conflicting(Word part) const {
    int best = lowest_bit(part);
    int most = -1;
    for_each_bit(part, [&](int edge) {
        const int degree = bit_count(static_cast<Word>(conflicts_[static_cast<std::size_t>(edge)] & part));
        if (degree > most) {
            most = degree;
            best = edge;
        }
    });
    return best;
}

template <class Word>
CountsBySize IndependentSets<Word>::count(Word edges) {
    CountsBySize result{1};
    while (edges != 0 && is_counted_) {
        const Word part = part_of_lowest(edges);
        result = product(result, count_part(part));
        edges &= ~part;
    }
    return result;
}

template <class Word>
const CountsBySize& IndependentSets<Word>::count_part(Word part) {
    if (const auto known = parts_.find(part); known != parts_.end()) return known->second;
    const int edge = most_conflicting(part);
    const Word others = part & ~single<Word>(edge);
    const CountsBySize without = count(others);
    const CountsBySize with = count(others & ~conflicts_[static_cast<std::size_t>(edge)]);
    is_counted_ = is_counted_ && parts_.size() < most_parts_;
    return parts_.emplace(part, sum(without, with)).first->second;
}

template <class Word>
CountsBySize IndependentSets<Word>::known_counts(Word edges) const {
    CountsBySize result{1};
    while (edges != 0) {
        const Word part = part_of_lowest(edges);
        result = product(result, known_part(part));
        edges &= ~part;
    }
    return result;
}

template <class Word>
Word IndependentSets<Word>::draw(int size, RandomStream& random) const {
    return draw_from(edges_, size, random);
}

/// Share the members out between the first part and the rest, by how many sets each share allows.
template <class Word>
Word IndependentSets<Word>::draw_from(Word edges, int size, RandomStream& random) const {
    Word chosen = 0;
    while (size > 0) {
        const Word part = part_of_lowest(edges);
        edges &= ~part;
        const CountsBySize& here = known_part(part);
        const CountsBySize rest = known_counts(edges);
        GraphCount pick = 0;
        for (int k = 0; k <= size; ++k) pick += entry(here, k) * entry(rest, size - k);
        pick = random.below(pick);
        int share = 0;
        while (pick >= entry(here, share) * entry(rest, size - share)) {
            pick -= entry(here, share) * entry(rest, size - share);
            ++share;
        }
        chosen |= draw_from_part(part, share, random);
        size -= share;
    }
    return chosen;
}

template <class Word>
Word IndependentSets<Word>::draw_from_part(Word part, int size, RandomStream& random) const {
    if (size == 0) return 0;
    const int edge = most_conflicting(part);
    const Word others = part & ~single<Word>(edge);
    const Word compatible = others & ~conflicts_[static_cast<std::size_t>(edge)];
    const GraphCount with = entry(known_counts(compatible), size - 1);
    if (random.below(entry(known_part(part), size)) < with)
        return single<Word>(edge) | draw_from(compatible, size - 1, random);
    return draw_from(others, size, random);
}

template class IndependentSets<Word64>;
template class IndependentSets<Word128>;

}  // namespace fretwork::pattern::detail

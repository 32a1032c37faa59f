// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/search/independent_sets.hpp>

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

/// `without` + x * `with`
CountsBySize sum(const CountsBySize& without, const CountsBySize& with) {
    CountsBySize result(std::max(without.size(), with.size() + 1));
    for (std::size_t i = 0; i < without.size(); ++i) result[i] += without[i];
    for (std::size_t i = 0; i < with.size(); ++i) result[i + 1] += with[i];
    return result;
}

GraphCount entry(const CountsBySize& counts, int size) {
    return size >= 0 && size < static_cast<int>(counts.size()) ? counts[size] : 0;
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
IndependentSets<Word>::IndependentSets(std::vector<Word> conflicts, Word edges, std::size_t most_parts,
                                       const base::Control& control)
    : conflicts_(std::move(conflicts)), most_parts_(most_parts) {
    Word possible = edges;
    for_each_bit(edges, [&](int edge) {
        if ((conflicts_[edge] & single<Word>(edge)) != 0) possible &= ~single<Word>(edge);
    });
    all_ = make_forest(possible, control);
    numbers_.clear();
}

/// The edges that chains of conflicts connect with the lowest edge.
template <class Word>
Word IndependentSets<Word>::part_of_lowest(Word edges) const {
    Word part = edges & (~edges + 1);
    for (Word front = part; front != 0;) {
        const Word fresh = conflicts_[lowest_bit(front)] & edges & ~part;
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
        const int degree = bit_count(static_cast<Word>(conflicts_[edge] & part));
        if (degree > most) {
            most = degree;
            best = edge;
        }
    });
    return best;
}

template <class Word>
typename IndependentSets<Word>::Forest IndependentSets<Word>::make_forest(Word edges,
                                                                          const base::Control& control) {
    Forest forest;
    while (edges != 0 && is_counted_) {
        const Word part = part_of_lowest(edges);
        forest.parts.push_back(make_part(part, control));
        edges &= ~part;
    }
    forest.tails.assign(forest.parts.size() + 1, CountsBySize{1});
    for (std::size_t i = forest.parts.size(); i-- > 0;)
        forest.tails[i] = product(parts_[forest.parts[i]].counts, forest.tails[i + 1]);
    return forest;
}

template <class Word>
std::size_t IndependentSets<Word>::make_part(Word edges, const base::Control& control) {
    control.check();
    if (const auto known = numbers_.find(edges); known != numbers_.end()) return known->second;
    Part part;
    part.edge = most_conflicting(edges);
    const Word others = edges & ~single<Word>(part.edge);
    part.without = make_forest(others, control);
    part.with = make_forest(others & ~conflicts_[part.edge], control);
    part.counts = sum(part.without.tails.front(), part.with.tails.front());
    is_counted_ = is_counted_ && parts_.size() < most_parts_;
    parts_.push_back(std::move(part));
    numbers_.emplace(edges, parts_.size() - 1);
    return parts_.size() - 1;
}

template <class Word>
Word IndependentSets<Word>::draw(int size, WideRandom& random) const {
    return draw_from(all_, size, random);
}

/// Divide the members between each part and the parts after it, with probabilities proportional to the number
/// of sets that each division allows.
template <class Word>
Word IndependentSets<Word>::draw_from(const Forest& forest, int size, WideRandom& random) const {
    Word chosen = 0;
    for (std::size_t i = 0; size > 0; ++i) {
        const Part& part = parts_[forest.parts[i]];
        const CountsBySize& tail = forest.tails[i + 1];
        GraphCount pick = random.below(entry(forest.tails[i], size));
        int share = 0;
        for (GraphCount ways = 0; pick >= (ways = entry(part.counts, share) * entry(tail, size - share));
             ++share)
            pick -= ways;
        chosen |= draw_from(part, share, random);
        size -= share;
    }
    return chosen;
}

template <class Word>
Word IndependentSets<Word>::draw_from(const Part& part, int size, WideRandom& random) const {
    if (size == 0) return 0;
    if (random.below(entry(part.counts, size)) < entry(part.with.tails.front(), size - 1))
        return single<Word>(part.edge) | draw_from(part.with, size - 1, random);
    return draw_from(part.without, size, random);
}

template class IndependentSets<Word64>;
template class IndependentSets<Word128>;

}  // namespace fretwork::pattern::detail

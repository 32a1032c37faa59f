// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/reduction/stratified_sample.hpp>

#include <algorithm>
#include <map>

namespace fretwork::reduction {
namespace {

struct Stratum {
    std::vector<std::size_t> members;
    std::size_t share = 0;
};

/// Set the number of items to take from each stratum: one more from each in turn, until enough are taken or
/// none are left.
void deal(std::map<int, Stratum>& strata, std::size_t size) {
    bool anything_taken = true;
    while (size > 0 && anything_taken) {
        anything_taken = false;
        for (auto& [label, stratum] : strata) {
            if (size == 0 || stratum.share == stratum.members.size()) continue;
            ++stratum.share;
            --size;
            anything_taken = true;
        }
    }
}

}  // namespace

std::vector<std::size_t> stratified_sample(std::span<const int> strata, std::size_t size) {
    std::map<int, Stratum> by_label;
    for (std::size_t i = 0; i < strata.size(); ++i) by_label[strata[i]].members.push_back(i);
    deal(by_label, size);
    std::vector<std::size_t> chosen;
    for (const auto& [label, stratum] : by_label) {
        for (std::size_t k = 0; k < stratum.share; ++k) {
            chosen.push_back(stratum.members[(2 * k + 1) * stratum.members.size() / (2 * stratum.share)]);
        }
    }
    std::ranges::sort(chosen);
    return chosen;
}

std::vector<pattern::Pattern> spread_over_edges(std::span<const pattern::Pattern> patterns,
                                                std::size_t size) {
    std::vector<int> edges;
    for (const pattern::Pattern& pattern : patterns) edges.push_back(pattern.edge_count());
    std::vector<pattern::Pattern> chosen;
    for (const std::size_t index : stratified_sample(edges, size)) chosen.push_back(patterns[index]);
    return chosen;
}

}  // namespace fretwork::reduction

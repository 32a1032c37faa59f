// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/parallel.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/pattern/census.hpp>
#include <fretwork/pattern/search/rule_counts.hpp>
#include <fretwork/pattern/search/rule_test.hpp>

#include <algorithm>

namespace fretwork::pattern {
namespace {

using detail::Word64;

/// For each number of edges, the number of graphs that break each rule, and the number that break none.
struct Tally {
    Tally(std::size_t edge_count, std::size_t filter_count)
        : rejected(edge_count + 1, std::vector<std::uint64_t>(filter_count)), valid(edge_count + 1) {}
    std::vector<std::vector<std::uint64_t>> rejected;
    std::vector<std::uint64_t> valid;

    void count(int edges, std::uint64_t broken) {
        if (broken == 0) ++valid[edges];
        detail::for_each_bit(broken, [&](int filter) { ++rejected[edges][filter]; });
    }
    void add(const Tally& other) {
        for (std::size_t k = 0; k < valid.size(); ++k) {
            valid[k] += other.valid[k];
            for (std::size_t i = 0; i < rejected[k].size(); ++i) rejected[k][i] += other.rejected[k][i];
        }
    }
};

/// Walk every graph. The bit set of its edges is a number; a piece is a range of numbers.
Tally tally_all_graphs(const NodeLayout& layout, const std::vector<Filter>& filters,
                       const EnumerationOptions& options) {
    constexpr Word64 kPiece = 1 << 12;
    const std::size_t edge_count = layout.candidate_edges().size();
    const Word64 end = Word64{1} << edge_count;
    const Tally nothing(edge_count, filters.size());
    std::vector<Tally> parts((end + kPiece - 1) / kPiece, nothing);
    base::parallel_for(parts.size(), options.threads, [&](std::size_t piece) {
        options.control.check();
        detail::RuleTest<Word64> test(layout, filters);
        const Word64 start = piece * kPiece;
        for (Word64 edges = start; edges < std::min(end, start + kPiece); ++edges) {
            const int count = detail::bit_count(edges);
            if (count >= options.edges.least && count <= options.edges.most)
                parts[piece].count(count, test.broken(edges));
        }
    });
    Tally sum = nothing;
    for (const Tally& part : parts) sum.add(part);
    return sum;
}

void fill(Census& census, const Tally& tally) {
    for (CensusRow& row : census.rows) {
        const auto& rejected = tally.rejected[row.edges];
        row.rejected.assign(rejected.begin(), rejected.end());
        row.valid = tally.valid[row.edges];
    }
}

/// Fill the columns of the filters that can be counted although there are too many graphs to walk.
void fill_without_walking(Census& census, const std::vector<Filter>& filters, int edge_count,
                          const base::Control& control) {
    for (const Filter& filter : filters) {
        control.check();
        const auto kept = detail::count_graphs_that_keep(filter.rule, edge_count, control);
        for (CensusRow& row : census.rows) {
            row.rejected.push_back(std::nullopt);
            if (kept) row.rejected.back() = row.patterns - (*kept)[row.edges];
        }
    }
}

}  // namespace

std::string count_text(GraphCount count) {
    std::string digits;
    do {
        digits += static_cast<char>('0' + static_cast<int>(count % 10));
        count /= 10;
    } while (count != 0);
    std::reverse(digits.begin(), digits.end());
    return digits;
}

GraphCount Census::valid() const {
    GraphCount sum = 0;
    for (const CensusRow& row : rows) sum += row.valid;
    return sum;
}

Census take_census(const NodeLayout& layout, const EnumerationOptions& options) {
    const bool is_walked = std::ssize(layout.candidate_edges()) <= kMostEdgesWalked;
    return take_census(layout, options, is_walked ? PatternCount{} : count_patterns(layout, options));
}

Census take_census(const NodeLayout& layout, const EnumerationOptions& options, const PatternCount& valid) {
    options.validate();
    const std::vector<Filter> filters = make_filters(layout, options.filters);
    Census census;
    for (const Filter& filter : filters) census.filters.push_back(filter.name);
    const int edge_count = static_cast<int>(layout.candidate_edges().size());
    for (int k = options.edges.least; k <= std::min(options.edges.most, edge_count); ++k)
        census.rows.push_back({k, detail::binomial(edge_count, k), {}, 0});
    if (edge_count <= kMostEdgesWalked) {
        fill(census, tally_all_graphs(layout, filters, options));
        return census;
    }
    for (CensusRow& row : census.rows) row.valid = valid.by_edges[row.edges];
    fill_without_walking(census, filters, edge_count, options.control);
    return census;
}

std::string census_csv(const Census& census) {
    std::string text = "edges,patterns";
    for (const std::string& filter : census.filters) text += "," + base::csv_field(filter);
    text += ",valid\n";
    for (const CensusRow& row : census.rows) {
        text += std::to_string(row.edges) + "," + count_text(row.patterns);
        for (const auto& count : row.rejected) text += "," + (count ? count_text(*count) : std::string());
        text += "," + count_text(row.valid) + "\n";
    }
    return text;
}

}  // namespace fretwork::pattern

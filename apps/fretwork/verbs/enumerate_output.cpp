// SPDX-License-Identifier: GPL-3.0-or-later
#include "output.hpp"
#include "verbs/enumerate_output.hpp"

#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/text.hpp>

#include <algorithm>
#include <cstdio>
#include <vector>

namespace fretwork::app {
namespace {

using base::Json;
using pattern::NodeLayout;

/// Numbers beyond 2^53 become text, since JSON readers may round larger ones.
Json json_count(pattern::GraphCount count) {
    constexpr pattern::GraphCount kLargestExact = pattern::GraphCount{1} << 53;
    if (count > kLargestExact) return pattern::count_text(count);
    return static_cast<std::uint64_t>(count);
}

/// The census as columns under their names, each as wide as it needs.
std::string census_table(const pattern::Census& census) {
    std::vector<std::vector<std::string>> rows;
    for (const std::string& line : base::split(pattern::census_csv(census), '\n')) {
        if (!line.empty()) rows.push_back(base::split(line, ','));
    }
    std::vector<std::size_t> widths(rows.front().size());
    for (const auto& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    std::string text;
    for (const auto& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i)
            text += std::string(widths[i] - row[i].size() + (i == 0 ? 0 : 2), ' ') + row[i];
        text += "\n";
    }
    return text;
}

Json census_json(const NodeLayout& layout, const pattern::Census& census) {
    Json rows = Json::array();
    for (const pattern::CensusRow& row : census.rows) {
        Json entry = {{"edges", row.edges}, {"patterns", json_count(row.patterns)}};
        for (std::size_t i = 0; i < census.filters.size(); ++i) {
            entry[census.filters[i]] = base::or_null(row.rejected[i], json_count);
        }
        entry["valid"] = json_count(row.valid);
        rows.push_back(std::move(entry));
    }
    return {{"layout", layout.name()},
            {"candidate_edges", layout.candidate_edges().size()},
            {"valid", json_count(census.valid())},
            {"census", std::move(rows)}};
}

}  // namespace

void print_count(const NodeLayout& layout, std::uint64_t count, Audience audience) {
    if (audience == Audience::Programs) {
        print_document({{"layout", layout.name()}, {"count", json_count(count)}});
    } else {
        std::printf("%s\n", std::to_string(count).c_str());
    }
}

void print_estimate(const NodeLayout& layout, const pattern::CountEstimate& estimate, Audience audience) {
    if (audience == Audience::Programs) {
        print_document({{"layout", layout.name()},
                        {"valid", estimate.valid},
                        {"lower", estimate.lower},
                        {"upper", estimate.upper},
                        {"confidence", estimate.confidence},
                        {"trials", estimate.trials},
                        {"hits", estimate.hits},
                        {"proposals", json_count(estimate.proposals)}});
        return;
    }
    std::printf("about %.4g valid patterns of the layout %s (between %.4g and %.4g with %g %% confidence)\n",
                estimate.valid, layout.name().c_str(), estimate.lower, estimate.upper,
                100 * estimate.confidence);
    std::printf("from %s hits in %s trials among %s graphs without conflicts\n",
                std::to_string(estimate.hits).c_str(), std::to_string(estimate.trials).c_str(),
                pattern::count_text(estimate.proposals).c_str());
}

void print_ids(const NodeLayout& layout, std::span<const pattern::Pattern> patterns, Audience audience) {
    Json ids = Json::array();
    for (const pattern::Pattern& found : patterns) {
        const std::string id = pattern_id(layout, found);
        if (audience == Audience::People) std::printf("%s\n", id.c_str());
        ids.push_back(id);
    }
    if (audience == Audience::Programs)
        print_document({{"layout", layout.name()}, {"patterns", std::move(ids)}});
}

void print_census(const NodeLayout& layout, const pattern::Census& census,
                  const std::optional<pattern::SamenessReport>& sameness, Audience audience) {
    if (audience == Audience::Programs) {
        Json document = census_json(layout, census);
        if (sameness) {
            document["up_to_mirror"] = sameness->up_to_mirror;
            document["up_to_isomorphism"] = sameness->up_to_isomorphism;
        }
        print_document(document);
        return;
    }
    std::fputs(census_table(census).c_str(), stdout);
    std::printf("\n%s valid patterns of the layout %s\n", pattern::count_text(census.valid()).c_str(),
                layout.name().c_str());
    if (sameness)
        std::printf("%s up to mirror images, %s up to isomorphism of their fans\n",
                    std::to_string(sameness->up_to_mirror).c_str(),
                    std::to_string(sameness->up_to_isomorphism).c_str());
}

}  // namespace fretwork::app

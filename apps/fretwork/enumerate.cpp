// SPDX-License-Identifier: GPL-3.0-or-later
#include "verbs.hpp"

#include <fretwork/base/detail/json_text.hpp>
#include <fretwork/base/error.hpp>
#include <fretwork/base/file.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/exports/pattern_drawing.hpp>
#include <fretwork/library/library.hpp>
#include <fretwork/pattern/census.hpp>
#include <fretwork/reduction/setting.hpp>

#include <charconv>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace fretwork::app {
namespace {

using base::detail::Json;
using pattern::NodeLayout;

constexpr const char* kExample = R"(
Examples:
  fretwork enumerate                                    the paper's Table 1
  fretwork enumerate --layout my.json --edges 3..8 --min-angle 20 --count
  fretwork enumerate --layout paper7 --census table1.csv --list patterns.txt)";

/// What a person asks for.
struct Wishes {
    std::string layout = "paper7";
    std::string edges;
    std::string min_angle;
    std::string max_valence;
    std::vector<std::string> filters;
    std::vector<std::string> required;
    std::vector<std::string> forbidden;
    std::string tile_side;
    std::string beam_width;
    int threads = 0;
    bool count = false;
    bool json = false;
    std::string census_path;
    std::string list_path;
    std::string library_path;
    std::string svg_path;
};

int parse_edge_count(std::string_view text, const std::string& all) {
    int number = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
    if (text.empty() || result.ec != std::errc{} || result.ptr != text.data() + text.size())
        throw base::InputError("--edges", "", "'" + all + "' is no range, such as 2..11 or 7");
    return number;
}

pattern::EdgeRange parse_range(const std::string& text) {
    const auto dots = text.find("..");
    if (dots == std::string::npos) {
        const int only = parse_edge_count(text, text);
        return {only, only};
    }
    return {parse_edge_count(std::string_view(text).substr(0, dots), text),
            parse_edge_count(std::string_view(text).substr(dots + 2), text)};
}

pattern::EnumerationOptions make_options(const Wishes& wishes, const NodeLayout& layout) {
    pattern::EnumerationOptions options;
    options.edges = wishes.edges.empty() ? pattern::default_edge_range(layout) : parse_range(wishes.edges);
    for (const std::string& filter : wishes.filters)
        options.filters.choices.push_back(pattern::parse_filter_choice(filter));
    if (!wishes.min_angle.empty())
        options.filters.choices.push_back({"small_angle", base::parse_angle(wishes.min_angle)});
    if (!wishes.max_valence.empty())
        options.filters.choices.push_back({"high_valence", base::parse_number(wishes.max_valence)});
    if (!wishes.tile_side.empty()) options.filters.scale.tile_side = base::parse_length(wishes.tile_side);
    if (!wishes.beam_width.empty()) options.filters.scale.beam_width = base::parse_length(wishes.beam_width);
    for (const std::string& text : wishes.required)
        options.filters.required.push_back(pattern::parse_edge_group(layout, text));
    for (const std::string& text : wishes.forbidden)
        options.filters.forbidden.push_back(pattern::parse_edge_group(layout, text));
    options.threads = wishes.threads;
    options.validate();
    return options;
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

/// Numbers of any size: beyond 2^53 as text, since JSON readers keep no more.
Json json_count(pattern::GraphCount count) {
    constexpr pattern::GraphCount kLargestExact = pattern::GraphCount{1} << 53;
    if (count > kLargestExact) return pattern::count_text(count);
    return static_cast<std::uint64_t>(count);
}

Json census_json(const NodeLayout& layout, const pattern::Census& census) {
    Json rows = Json::array();
    for (const pattern::CensusRow& row : census.rows) {
        Json entry = {{"edges", row.edges}, {"patterns", json_count(row.patterns)}};
        for (std::size_t i = 0; i < census.filters.size(); ++i)
            entry[census.filters[i]] = row.rejected[i] ? json_count(*row.rejected[i]) : Json(nullptr);
        entry["valid"] = json_count(row.valid);
        rows.push_back(std::move(entry));
    }
    return {{"layout", layout.name()},
            {"candidate_edges", layout.candidate_edges().size()},
            {"valid", json_count(census.valid())},
            {"census", std::move(rows)}};
}

void print_count(const NodeLayout& layout, const pattern::EnumerationOptions& options, const Wishes& wishes) {
    const std::uint64_t total = pattern::count_patterns(layout, options).total();
    const std::string text = std::to_string(total);
    const Json document = {{"layout", layout.name()}, {"count", json_count(total)}};
    std::fputs(wishes.json ? base::detail::json_text(document).c_str() : (text + "\n").c_str(), stdout);
}

void print_census(const NodeLayout& layout, const pattern::Census& census, const Wishes& wishes) {
    if (wishes.json) {
        std::fputs(base::detail::json_text(census_json(layout, census)).c_str(), stdout);
        return;
    }
    std::fputs(census_table(census).c_str(), stdout);
    std::printf("\n%s valid patterns of the layout %s\n", pattern::count_text(census.valid()).c_str(),
                layout.name().c_str());
}

void write_list(const NodeLayout& layout, const pattern::EnumerationOptions& options,
                const std::string& path) {
    base::AtomicFile file(path);
    pattern::for_each_pattern(layout, options, [&](const pattern::Pattern& found) {
        file.write(pattern::pattern_id(layout, found) + "\n");
    });
    file.commit();
}

std::vector<pattern::Pattern> all_patterns(const NodeLayout& layout,
                                           const pattern::EnumerationOptions& options) {
    std::vector<pattern::Pattern> patterns;
    pattern::for_each_pattern(layout, options,
                              [&](const pattern::Pattern& found) { patterns.push_back(found); });
    return patterns;
}

/// A library that is there keeps its setting; a new one gets the paper's, until it is calibrated with
/// another.
void add_to_library(const NodeLayout& layout, const pattern::EnumerationOptions& options,
                    const std::string& path) {
    auto library = std::filesystem::exists(path)
                       ? library::Library::open(path, library::Access::ReadWrite)
                       : library::Library::create(path, layout, reduction::paper_setting());
    library.check_layout(layout);
    library.add_patterns(all_patterns(layout, options));
}

void enumerate(const Wishes& wishes) {
    const NodeLayout layout = pattern::find_node_layout(wishes.layout);
    const pattern::EnumerationOptions options = make_options(wishes, layout);
    if (wishes.count) {
        print_count(layout, options, wishes);
        return;
    }
    const pattern::Census census = pattern::take_census(layout, options);
    if (!wishes.list_path.empty()) write_list(layout, options, wishes.list_path);
    if (!wishes.census_path.empty())
        base::write_file_atomically(wishes.census_path, pattern::census_csv(census));
    if (!wishes.library_path.empty()) add_to_library(layout, options, wishes.library_path);
    if (!wishes.svg_path.empty()) {
        base::write_file_atomically(wishes.svg_path,
                                    exports::pattern_sheet_svg(layout, all_patterns(layout, options)));
    }
    print_census(layout, census, wishes);
}

std::string filter_help() {
    std::string text = "Set a filter, or switch one on:";
    for (const pattern::FilterKind& kind : pattern::filter_catalogue())
        text += "\n" + std::string(kind.name) + ": " + std::string(kind.doc);
    return text;
}

}  // namespace

void add_enumerate(CLI::App& app, ExitCode&) {
    const auto wishes = std::make_shared<Wishes>();
    CLI::App* verb = app.add_subcommand(
        "enumerate", "Find all valid patterns of a node layout, and say why the others are not.");
    verb->add_option("--layout", wishes->layout, "The name of a layout, or its file")->capture_default_str();
    verb->add_option("--edges", wishes->edges,
                     "Numbers of edges, as A..B or N (default: 2..11 for paper7, else 2..all)");
    verb->add_option("--min-angle", wishes->min_angle,
                     "The smallest angle between two beams (default: 15deg)");
    verb->add_option("--max-valence", wishes->max_valence, "The most beams that meet in a node (default: 6)");
    verb->add_option("--filter", wishes->filters, filter_help())->type_name("NAME[=VALUE]");
    verb->add_option("--tile-side", wishes->tile_side,
                     "What lengths refer to: the side of the hexagon (default: 25.98mm)");
    verb->add_option("--beam-width", wishes->beam_width, "The width of the beams in it (default: 2mm)");
    verb->add_option("--require", wishes->required, "Edges (1-6) or nodes (n5) that every pattern uses")
        ->delimiter(',');
    verb->add_option("--forbid", wishes->forbidden, "Edges or nodes that no pattern uses")->delimiter(',');
    verb->add_option("--threads", wishes->threads, "Threads to use; 0: all there are");
    verb->add_flag("--count", wishes->count, "Print only how many valid patterns there are");
    verb->add_option("--census", wishes->census_path, "Write the census to this CSV file");
    verb->add_option("--list", wishes->list_path,
                     "Write the ids of the valid patterns to this file, one a line");
    verb->add_option("--library", wishes->library_path,
                     "Add the valid patterns to this library (made if it is not there)");
    verb->add_option("--svg", wishes->svg_path, "Draw the valid patterns on one sheet");
    verb->add_flag("--json", wishes->json, "Print for programs");
    verb->footer(kExample);
    verb->callback([wishes] { enumerate(*wishes); });
}

}  // namespace fretwork::app

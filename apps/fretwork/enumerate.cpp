// SPDX-License-Identifier: GPL-3.0-or-later
#include "enumerate_output.hpp"
#include "file_options.hpp"
#include "verbs.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/file.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/exports/rejection_drawing.hpp>
#include <fretwork/pattern/rejections.hpp>

#include <memory>
#include <optional>

namespace fretwork::app {
namespace {

using pattern::NodeLayout;

constexpr const char* kExample = R"(
Examples:
  fretwork enumerate                                    the paper's Table 1
  fretwork enumerate --layout my.json --edges 3..8 --min-angle 20 --count
  fretwork enumerate --layout paper7 --census table1.csv --list patterns.txt --classes classes.csv
  fretwork enumerate --edges 4 --svg sheet.svg
  fretwork enumerate --svg rejected.svg --reasons
  fretwork enumerate --layout huge.json --estimate 100000
  fretwork enumerate --layout huge.json --sample 20 --seed 7)";

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
    bool reasons = false;
    std::string classes_path;
    std::size_t sample = 0;
    std::uint64_t estimate = 0;
    std::uint64_t seed = 1;
};

int parse_edge_count(std::string_view text, const std::string& all) {
    if (const auto number = base::read_number<int>(text)) return *number;
    throw base::InputError("--edges", "", "'" + all + "' is no range, such as 2..11, 3..all or 7");
}

pattern::EdgeRange parse_range(const std::string& text, const NodeLayout& layout) {
    const auto most = static_cast<int>(layout.candidate_edges().size());
    const auto dots = text.find("..");
    const std::string least = text.substr(0, dots);
    const std::string last = dots == std::string::npos ? least : text.substr(dots + 2);
    const pattern::EdgeRange range{parse_edge_count(least, text),
                                   last == "all" ? most : parse_edge_count(last, text)};
    if (range.least > most)
        throw base::InputError("--edges", "",
                               "'" + text + "' begins beyond the " + std::to_string(most) +
                                   " candidate edges of the layout " + layout.name());
    return range;
}

pattern::EnumerationOptions make_options(const Wishes& wishes, const NodeLayout& layout) {
    pattern::EnumerationOptions options;
    options.edges =
        wishes.edges.empty() ? pattern::default_edge_range(layout) : parse_range(wishes.edges, layout);
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

Audience audience_of(const Wishes& wishes) {
    return wishes.json ? Audience::Programs : Audience::People;
}

bool is_wanted(const std::string& path) {
    return !path.empty();
}

/// The patterns that files are made of: all, or a sample.
std::vector<pattern::Pattern> find_patterns(const NodeLayout& layout,
                                            const pattern::EnumerationOptions& options,
                                            const Wishes& wishes) {
    if (wishes.sample > 0) return pattern::PatternSampler(layout, options, wishes.seed).draw(wishes.sample);
    return pattern::enumerate_patterns(layout, options);
}

/// Written as they are found: a list of millions is not kept.
void write_list(const NodeLayout& layout, const pattern::EnumerationOptions& options, const Wishes& wishes) {
    base::AtomicFile file(wishes.list_path);
    const auto write = [&](const pattern::Pattern& found) { file.write(pattern_id(layout, found) + "\n"); };
    if (wishes.sample > 0) {
        for (const pattern::Pattern& found : find_patterns(layout, options, wishes)) write(found);
    } else {
        pattern::for_each_pattern(layout, options, write);
    }
    file.commit();
}

void write_sheet(const NodeLayout& layout, const pattern::EnumerationOptions& options, const Wishes& wishes) {
    constexpr std::size_t kRejectedPerFilter = 8;
    exports::PatternDrawingOptions drawing;
    drawing.tile_side = options.filters.scale.tile_side;
    drawing.beam_width = options.filters.scale.beam_width;
    if (wishes.reasons) {
        const auto rejections = pattern::find_rejections(layout, options, kRejectedPerFilter);
        base::write_file_atomically(wishes.svg_path,
                                    exports::rejection_sheet_svg(layout, rejections, drawing));
        return;
    }
    check_sheet_size(wishes.sample > 0 ? wishes.sample : pattern::count_patterns(layout, options).total());
    base::write_file_atomically(
        wishes.svg_path, exports::pattern_sheet_svg(layout, find_patterns(layout, options, wishes), drawing));
}

std::optional<pattern::SamenessReport> write_classes(const NodeLayout& layout,
                                                     const pattern::EnumerationOptions& options,
                                                     const Wishes& wishes) {
    if (!is_wanted(wishes.classes_path)) return std::nullopt;
    const std::vector<pattern::Pattern> patterns = pattern::enumerate_patterns(layout, options);
    pattern::SamenessReport report = pattern::find_sameness(layout, patterns, options.threads);
    base::write_file_atomically(wishes.classes_path, pattern::sameness_csv(layout, patterns, report));
    return report;
}

void write_files(const NodeLayout& layout, const pattern::EnumerationOptions& options, const Wishes& wishes) {
    if (is_wanted(wishes.list_path)) write_list(layout, options, wishes);
    if (is_wanted(wishes.library_path))
        add_to_library(layout, find_patterns(layout, options, wishes), wishes.library_path);
    if (is_wanted(wishes.svg_path)) write_sheet(layout, options, wishes);
}

void enumerate(const Wishes& wishes) {
    const NodeLayout layout = pattern::find_node_layout(wishes.layout);
    const pattern::EnumerationOptions options = make_options(wishes, layout);
    if (wishes.count) {
        print_count(layout, pattern::count_patterns(layout, options).total(), audience_of(wishes));
        return;
    }
    if (wishes.estimate > 0) {
        const pattern::PatternSampler sampler(layout, options, wishes.seed);
        print_estimate(layout, sampler.estimate(wishes.estimate), audience_of(wishes));
        return;
    }
    write_files(layout, options, wishes);
    if (wishes.sample > 0) {
        print_ids(layout, find_patterns(layout, options, wishes), audience_of(wishes));
        return;
    }
    const pattern::Census census = pattern::take_census(layout, options);
    if (is_wanted(wishes.census_path))
        base::write_file_atomically(wishes.census_path, pattern::census_csv(census));
    print_census(layout, census, write_classes(layout, options, wishes), audience_of(wishes));
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
    verb->add_option("--census", wishes->census_path, "Write the census to this CSV file");
    verb->add_option("--list", wishes->list_path,
                     "Write the ids of the valid patterns to this file, one a line");
    verb->add_option("--library", wishes->library_path,
                     "Add the valid patterns to this library (made if it is not there)");
    verb->add_option("--svg", wishes->svg_path, "Draw the valid patterns on one sheet");
    CLI::Option* svg = verb->get_option("--svg");
    verb->add_flag("--reasons", wishes->reasons, "Draw rejected ones instead, the guilty beams in red")
        ->needs(svg);
    verb->add_option("--classes", wishes->classes_path,
                     "Write symmetry, mirror partner and isomorphism class of each pattern to this CSV file");
    verb->add_option("--sample", wishes->sample,
                     "Draw this many valid patterns at random instead of all, each equally likely")
        ->check(CLI::Range(1, 1'000'000'000))
        ->excludes("--census")
        ->excludes("--classes");
    verb->add_option("--estimate", wishes->estimate,
                     "Only estimate how many there are, from this many random trials")
        ->check(CLI::Range(1, 1'000'000'000))
        ->excludes("--sample");
    CLI::Option* count =
        verb->add_flag("--count", wishes->count, "Print only how many valid patterns there are");
    for (const char* other :
         {"--census", "--list", "--library", "--svg", "--classes", "--sample", "--estimate"})
        count->excludes(other);
    verb->add_option("--seed", wishes->seed, "What randomness starts from")
        ->check(seed_check())
        ->capture_default_str();
    verb->add_flag("--json", wishes->json, "Print for programs");
    declare_files(*verb, {input("--layout"), output("--census", kTableFile), output("--list", kListFile),
                          update("--library", kLibraryFile), output("--svg", kSvgFile),
                          output("--classes", kTableFile)});
    verb->footer(kExample);
    verb->callback([wishes] { enumerate(*wishes); });
}

}  // namespace fretwork::app

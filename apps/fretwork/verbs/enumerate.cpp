// SPDX-License-Identifier: GPL-3.0-or-later
#include "interrupt.hpp"
#include "options/checks.hpp"
#include "options/file_options.hpp"
#include "verbs.hpp"
#include "verbs/enumerate_files.hpp"
#include "verbs/enumerate_output.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/exports/drawings/pattern_drawing.hpp>
#include <fretwork/pattern/rejections.hpp>

#include <algorithm>
#include <memory>

namespace fretwork::app {
namespace {

using pattern::NodeLayout;

constexpr const char* kEnumerateExample = R"(
Examples:
  fretwork enumerate                                    the paper's Table 1
  fretwork enumerate --layout my.json --edges 3..8 --min-angle 20 --count
  fretwork enumerate --layout paper7 --census table1.csv --list patterns.txt --classes classes.csv
  fretwork enumerate --edges 4 --svg sheet.svg
  fretwork enumerate --svg rejected.svg --reasons
  fretwork enumerate --layout huge.json --estimate 100000
  fretwork enumerate --layout huge.json --sample 20 --seed 7)";

struct EnumerateOptions {
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
    throw base::InputError("--edges", "", "'" + all + "' is not a range, such as 2..11, 3..all or 7");
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

/// The enumeration that the options ask for.
pattern::EnumerationOptions make_enumeration(const EnumerateOptions& options, const NodeLayout& layout) {
    pattern::EnumerationOptions enumeration;
    pattern::FilterSettings& filters = enumeration.filters;
    enumeration.edges =
        options.edges.empty() ? pattern::default_edge_range(layout) : parse_range(options.edges, layout);
    for (const std::string& filter : options.filters)
        filters.choices.push_back(pattern::parse_filter_choice(filter));
    if (!options.min_angle.empty())
        filters.choices.push_back({"small_angle", base::parse_angle(options.min_angle)});
    if (!options.max_valence.empty())
        filters.choices.push_back({"high_valence", base::parse_number(options.max_valence)});
    if (!options.tile_side.empty()) filters.scale.tile_side = base::parse_length(options.tile_side);
    if (!options.beam_width.empty()) filters.scale.beam_width = base::parse_length(options.beam_width);
    for (const std::string& text : options.required)
        filters.required.push_back(pattern::parse_edge_group(layout, text));
    for (const std::string& text : options.forbidden)
        filters.forbidden.push_back(pattern::parse_edge_group(layout, text));
    enumeration.threads = options.threads;
    enumeration.validate();
    return enumeration;
}

Audience audience_of(const EnumerateOptions& options) {
    return options.json ? Audience::Programs : Audience::People;
}

exports::PatternDrawingOptions drawing_options(const pattern::EnumerationOptions& enumeration) {
    exports::PatternDrawingOptions drawing;
    drawing.tile_side = enumeration.filters.scale.tile_side;
    drawing.beam_width = enumeration.filters.scale.beam_width;
    return drawing;
}

/// Refuses options without an effect, which are a misunderstanding.
void refuse_ignored_options(const CLI::App& verb, const EnumerateOptions& options) {
    const bool is_random = options.sample > 0 || options.estimate > 0;
    if (verb.count("--seed") > 0 && !is_random)
        throw base::InputError(
            "--seed works with --sample or --estimate; finding all patterns needs no random numbers");
    const bool has_lengths =
        !options.svg_path.empty() || std::ranges::any_of(options.filters, [](const std::string& filter) {
            return pattern::find_filter_kind(pattern::parse_filter_choice(filter).name).parameter ==
                   pattern::FilterParameter::Length;
        });
    for (const char* option : {"--tile-side", "--beam-width"}) {
        if (verb.count(option) > 0 && !has_lengths)
            throw base::InputError(
                std::string(option) +
                " works with --svg or a filter of lengths, such as --filter short_edge=3mm");
    }
}

std::string rejection_sheet(const NodeLayout& layout, const pattern::EnumerationOptions& enumeration) {
    constexpr std::size_t kRejectedPerFilter = 8;
    return exports::rejection_sheet_svg(layout,
                                        pattern::find_rejections(layout, enumeration, kRejectedPerFilter),
                                        drawing_options(enumeration));
}

/// Choose some patterns at random, print their ids, and make the files of them.
void sample(const NodeLayout& layout, const pattern::EnumerationOptions& enumeration, PatternFiles& files,
            const EnumerateOptions& options) {
    const auto drawn = pattern::PatternSampler(layout, enumeration, options.seed).draw(options.sample);
    for (const pattern::Pattern& pattern : drawn) files.take(pattern);
    (void)files.finish({.threads = enumeration.threads, .control = enumeration.control});
    print_ids(layout, drawn, audience_of(options));
}

/// Search once, print the census, and make the files.
void search(const NodeLayout& layout, const pattern::EnumerationOptions& enumeration, PatternFiles& files,
            const EnumerateOptions& options) {
    const pattern::Census census =
        files.are_wanted()
            ? pattern::take_census(layout, enumeration,
                                   pattern::for_each_pattern(layout, enumeration,
                                                             [&](const auto& found) { files.take(found); }))
            : pattern::take_census(layout, enumeration);
    if (!options.census_path.empty()) files.add(options.census_path, pattern::census_csv(census));
    if (options.reasons) files.add(options.svg_path, rejection_sheet(layout, enumeration));
    const auto sameness = files.finish({.threads = enumeration.threads, .control = enumeration.control});
    print_census(layout, census, sameness, audience_of(options));
}

void enumerate(const EnumerateOptions& options) {
    LongWork work;
    const NodeLayout layout = pattern::find_node_layout(options.layout);
    pattern::EnumerationOptions enumeration = make_enumeration(options, layout);
    enumeration.control = work.control();
    if (options.count) {
        print_count(layout, pattern::count_patterns(layout, enumeration).total(), audience_of(options));
        return;
    }
    if (options.estimate > 0) {
        const pattern::PatternSampler sampler(layout, enumeration, options.seed);
        print_estimate(layout, sampler.estimate(options.estimate), audience_of(options));
        return;
    }
    PatternFiles files(layout,
                       {.list = options.list_path,
                        .library = options.library_path,
                        .sheet = options.reasons ? std::string() : options.svg_path,
                        .classes = options.classes_path},
                       drawing_options(enumeration));
    (options.sample > 0 ? sample : search)(layout, enumeration, files, options);
}

std::string filter_help() {
    std::string text =
        "Set a filter, or switch one on; those down to high_valence are always on. A pattern is rejected if:";
    for (const pattern::FilterKind& kind : pattern::filter_catalogue())
        text += "\n" + std::string(kind.name) + ": " + std::string(kind.summary);
    return text;
}

/// Adds the options that say which patterns are valid.
void add_rules(CLI::App& verb, EnumerateOptions& options) {
    verb.add_option("--layout", options.layout, "Node layout: a name or a file")->capture_default_str();
    verb.add_option("--edges", options.edges,
                    "Number of edges of the patterns: N, or from A to B as A..B (default: 2..11 for paper7, "
                    "else 2..all)");
    verb.add_option("--min-angle", options.min_angle,
                    "Smallest angle between two beams: the filter small_angle (default: 15deg)");
    verb.add_option("--max-valence", options.max_valence,
                    "Maximum number of beams that meet in a node: the filter high_valence (default: 6)");
    verb.add_option("--filter", options.filters, filter_help())->type_name("NAME[=VALUE]");
    verb.add_option("--tile-side", options.tile_side,
                    "Side of the tile, for filters with lengths and for --svg (default: 25.98mm)");
    verb.add_option("--beam-width", options.beam_width,
                    "Width of the beams, for tight_clearance and --svg (default: 2mm)");
    verb.add_option("--require", options.required, "Edges (1-6) or nodes (n5) that every pattern uses")
        ->delimiter(',');
    verb.add_option("--forbid", options.forbidden, "Edges or nodes that no pattern uses")->delimiter(',');
}

void add_files(CLI::App& verb, EnumerateOptions& options) {
    verb.add_option(
        "--census", options.census_path,
        "Write the census to this CSV file: numbers of patterns for each number of edges and each filter");
    verb.add_option("--list", options.list_path,
                    "Write the ids of the valid patterns to this file, one on each line");
    verb.add_option("--library", options.library_path,
                    "Add the valid patterns to this library (created if it does not exist)");
    CLI::Option* svg = verb.add_option("--svg", options.svg_path, "Draw the valid patterns on one sheet");
    verb.add_flag("--reasons", options.reasons,
                  "Draw rejected patterns instead, with the beams that cause the rejection in red")
        ->needs(svg);
    verb.add_option("--classes", options.classes_path,
                    "Write for each valid pattern its symmetry, its mirror image and its class of isomorphic "
                    "patterns to this CSV file");
    declare_files(verb, {input("--layout"), output("--census", kCensusFile), output("--list", kListFile),
                         update("--library", kLibraryFile), output("--svg", kSvgFile),
                         output("--classes", kClassesFile)});
}

/// Adds the options to find only some patterns, or only their number.
void add_extent(CLI::App& verb, EnumerateOptions& options) {
    CLI::Option* sample = verb.add_option("--sample", options.sample,
                                          "Choose this number of valid patterns at random instead of finding "
                                          "all. All are equally likely, and one may be chosen several times")
                              ->check(CLI::Range(1, 1'000'000'000));
    CLI::Option* estimate =
        verb.add_option("--estimate", options.estimate,
                        "Only estimate the number of valid patterns, from this number of random trials")
            ->check(CLI::Range(1, 1'000'000'000));
    CLI::Option* count = verb.add_flag("--count", options.count, "Print only the number of valid patterns");
    for (const char* other : {"--census", "--reasons", "--classes"}) sample->excludes(other);
    for (const char* other : {"--sample", "--census", "--list", "--library", "--svg", "--classes"}) {
        estimate->excludes(other);
        count->excludes(other);
    }
    count->excludes(estimate);
    verb.add_option("--seed", options.seed, "Seed of --sample and --estimate")
        ->check(seed_check())
        ->capture_default_str();
}

}  // namespace

void add_enumerate(CLI::App& app, ExitCode&) {
    const auto options = std::make_shared<EnumerateOptions>();
    CLI::App* verb = app.add_subcommand(
        "enumerate",
        "Find all valid patterns of a node layout, and count how many of the others each filter rejects");
    add_rules(*verb, *options);
    add_files(*verb, *options);
    add_extent(*verb, *options);
    verb->add_option("--threads", options->threads, "Threads to use; 0: one for each processor")
        ->check(thread_check());
    verb->add_flag("--json", options->json, "Print JSON");
    verb->footer(kEnumerateExample);
    verb->callback([options, verb] {
        refuse_ignored_options(*verb, *options);
        enumerate(*options);
    });
}

}  // namespace fretwork::app

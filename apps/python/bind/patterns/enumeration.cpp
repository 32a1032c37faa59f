// SPDX-License-Identifier: GPL-3.0-or-later
// Filters, enumeration, census, samples and sameness of patterns.
#include "core/bind.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/pattern/census.hpp>
#include <fretwork/pattern/enumerate.hpp>
#include <fretwork/pattern/filter_catalogue.hpp>
#include <fretwork/pattern/rejections.hpp>
#include <fretwork/pattern/sameness.hpp>
#include <fretwork/pattern/sample.hpp>

namespace pybind11::detail {

/// Counts of graphs, which may need more than 64 bits.
template <>
struct type_caster<fretwork::pattern::GraphCount> {
    PYBIND11_TYPE_CASTER(fretwork::pattern::GraphCount, const_name("int"));
    bool load(handle, bool) { return false; }
    static handle cast(const fretwork::pattern::GraphCount& count, return_value_policy, handle) {
        return fretwork::python::int_of_digits(fretwork::pattern::count_text(count)).release();
    }
};

}  // namespace pybind11::detail

namespace fretwork::python {
namespace {

using namespace pattern;

void check_groups(const NodeLayout& layout, const FilterSettings& settings) {
    for (const auto* groups : {&settings.required, &settings.forbidden})
        for (const EdgeGroup& group : *groups) check(layout, Pattern(group.edges));
}

void bind_filter_values(py::module_& m) {
    bind_enum<FilterParameter>(m);
    Record<FilterKind>(m, "FilterKind", "A row of the catalogue: one reason to reject a pattern.")
        .constant("name", &FilterKind::name, "name on the command line and in the census")
        .constant("summary", &FilterKind::summary, "one line about the patterns that the filter rejects")
        .constant("parameter", &FilterKind::parameter,
                  "the filter's number: radians, a whole number, or metres")
        .constant("is_of_the_paper", &FilterKind::is_of_the_paper, "always on")
        .constant("default_value", &FilterKind::default_value, "")
        .done(Made::ByFunctions);
    Record<FilterChoice>(m, "FilterChoice", "The choice of a filter, with its number.")
        .field("name", &FilterChoice::name, "name of a row of the catalogue")
        .field("value", &FilterChoice::value,
               "the filter's number: radians, a whole number, or metres; None: the catalogue's default")
        .done();
    Record<EdgeGroup>(m, "EdgeGroup", "A set of edges with a name for people.")
        .field("name", &EdgeGroup::name, "'node n6'")
        .field("edges", &EdgeGroup::edges, "numbers of candidate edges")
        .done();
    Record<FabricationScale>(m, "FabricationScale", "The lengths for rules in millimetres.")
        .field("tile_side", &FabricationScale::tile_side, "m")
        .field("beam_width", &FabricationScale::beam_width, "m")
        .done();
    Record<Verdict>(m, "Verdict", "A filter's verdict on a pattern.")
        .field("accepted", &Verdict::accepted, "")
        .field("filter", &Verdict::filter, "name of the filter that rejects the pattern; empty if accepted")
        .field("reason", &Verdict::reason, "reason in one sentence; empty if accepted")
        .field("guilty", &Verdict::guilty, "numbers of the candidate edges that break the rule, drawn in red")
        .done();
}

void bind_filters(py::module_& m) {
    py::class_<Filter>(
        m, "Filter",
        "A filter with its rule for one layout, from make_filters() or your own.\n\n>>> import fretwork\n>>> "
        "layout = fretwork.paper_layout()\n>>> few = fretwork.Filter('many', lambda pattern: len(pattern) < "
        "4, 'has many beams')\n>>> settings = fretwork.FilterSettings(own=[few])\n>>> max(map(len, "
        "fretwork.enumerate_patterns(layout, filters=settings)))\n3\n")
        .def(py::init([](std::string name, std::function<bool(const Pattern&)> is_kept, std::string phrase) {
                 return Filter{std::move(name), 0.0, PredicateRule{std::move(is_kept), std::move(phrase)}};
             }),
             "name"_a, "is_kept"_a, "phrase"_a = "the pattern is rejected",
             "A filter of your own: `is_kept(pattern)` returns True if a pattern stays. It is called for "
             "each pattern that the other filters keep, from several threads, but one at a time. "
             "layout.candidate_edges[e] are the nodes of an edge e of pattern.edges.")
        .def_property_readonly("name", [](const Filter& self) { return self.name; })
        .def_property_readonly(
            "value", [](const Filter& self) { return self.value; },
            "number of a filter of the catalogue (radians, a whole number, or metres); 0 for your own")
        .def("__repr__", [](const Filter& self) { return "<Filter " + self.name + ">"; });
    Record<FilterSettings>(m, "FilterSettings", "The requirements on patterns.")
        .field("choices", &FilterSettings::choices,
               "list of FilterChoice: numbers for the paper's six filters, and further filters")
        .field("required", &FilterSettings::required,
               "list of EdgeGroup; a pattern has at least one edge of each")
        .field("forbidden", &FilterSettings::forbidden, "list of EdgeGroup; a pattern has no edge of any")
        .field("scale", &FilterSettings::scale, "side and width to which filters in metres refer")
        .field("own", &FilterSettings::own, "list of your own Filter, for one layout")
        .done();
    m.def(
        "filter_catalogue", [] { return filter_catalogue(); }, "All filters, the paper's six first.");
    m.def(
        "find_filter_kind", [](std::string_view name) { return find_filter_kind(name); }, "name"_a);
    m.def("parse_filter_choice", &parse_filter_choice, "text"_a,
          "Parse the choice of a filter: 'small_angle=20deg', 'short_edge=3mm' or 'asymmetric'.");
    m.def("parse_edge_group", &parse_edge_group, "layout"_a, "text"_a,
          "Parse an edge ('0-1') or a node ('n5': all edges at this node of the fan).");
    m.def(
        "make_filters",
        [](const NodeLayout& layout, const FilterSettings& settings) {
            check_groups(layout, settings);
            return make_filters(layout, settings);
        },
        "layout"_a, "settings"_a = FilterSettings{}, "The filters of these settings for one layout.");
    m.def(
        "judge",
        [](const NodeLayout& layout, const std::vector<Filter>& filters, const Pattern& pattern) {
            check(layout, pattern);
            return judge(layout, filters, pattern);
        },
        "layout"_a, "filters"_a, "pattern"_a,
        "The verdict of the first filter that rejects a pattern.\n\n"
        ">>> import fretwork\n"
        ">>> layout = fretwork.paper_layout()\n"
        ">>> lonely = fretwork.parse_pattern_id(layout, '0-1')\n"
        ">>> fretwork.judge(layout, fretwork.make_filters(layout), lonely).filter\n"
        "'no_interface'\n");
}

void bind_enumeration_functions(py::module_& m) {
    Record<EdgeRange>(m, "EdgeRange", "The range of the number of edges of a pattern, both ends included.")
        .field("least", &EdgeRange::least, "")
        .field("most", &EdgeRange::most, "")
        .done();
    m.def(
        "default_edge_range", &default_edge_range, "layout"_a,
        "The default range: 2 to 11 for the paper's layout, as in its table; 2 to all for any other layout.");
    Record<EnumerationOptions>(m, "EnumerationOptions", "Options of the enumeration.")
        .field("edges", &EnumerationOptions::edges,
               "EdgeRange(least, most) of the number of edges; an upper end beyond the number of candidate "
               "edges is clipped")
        .field("filters", &EnumerationOptions::filters, "FilterSettings: the rules that patterns keep")
        .field("threads", &EnumerationOptions::threads,
               "number of threads; 0: one for each processor; the result does not depend on the number")
        .field("most_kept", &EnumerationOptions::most_kept,
               "largest number of patterns that each piece of the search stores until they are passed on in "
               "order")
        .done();
    Record<PatternCount>(m, "PatternCount", "The number of patterns, by their number of edges.")
        .constant("by_edges", &PatternCount::by_edges, "entry k: number of patterns with k edges")
        .done(Made::ByFunctions)
        .def_property_readonly("total", &PatternCount::total);
    m.def(
        "enumerate_patterns",
        [](const NodeLayout& layout, const py::kwargs& named) {
            Keywords<EnumerationOptions> keywords(named);
            check_groups(layout, keywords.options.filters);
            return keywords.run([&](const auto& options) { return enumerate_patterns(layout, options); });
        },
        "layout"_a,
        "All valid patterns, in lexicographic order of their edge lists.\n\n"
        "Options: EnumerationOptions, progress\n\n"
        ">>> import fretwork\n"
        ">>> len(fretwork.enumerate_patterns(fretwork.paper_layout()))\n"
        "1824\n");
    m.def(
        "for_each_pattern",
        [](const NodeLayout& layout, const std::function<void(const Pattern&)>& visit,
           const py::kwargs& named) {
            Keywords<EnumerationOptions> keywords(named);
            check_groups(layout, keywords.options.filters);
            return keywords.run(
                [&](const auto& options) { return for_each_pattern(layout, options, visit); });
        },
        "layout"_a, "visit"_a,
        "Call visit(pattern) for every valid pattern; memory does not grow with their number.\n\n"
        "Options: EnumerationOptions, progress\n");
    m.def(
        "count_patterns",
        [](const NodeLayout& layout, const py::kwargs& named) {
            Keywords<EnumerationOptions> keywords(named);
            check_groups(layout, keywords.options.filters);
            return keywords.run([&](const auto& options) { return count_patterns(layout, options); });
        },
        "layout"_a, "Count the valid patterns.\n\nOptions: EnumerationOptions, progress\n");
}

void bind_census(py::module_& m) {
    Record<CensusRow>(m, "CensusRow", "A row of the census: the graphs with one number of edges.")
        .constant("edges", &CensusRow::edges, "")
        .constant("patterns", &CensusRow::patterns,
                  "number of all graphs with this number of candidate edges")
        .constant("rejected", &CensusRow::rejected,
                  "for each filter, number of graphs that break its rule; None if it cannot be counted")
        .constant("valid", &CensusRow::valid, "number of graphs that keep every rule")
        .done(Made::ByFunctions);
    Record<Census>(m, "Census", "The paper's Table 1, for any layout.")
        .constant("filters", &Census::filters, "names of the columns of `rejected`")
        .constant("rows", &Census::rows, "")
        .done(Made::ByFunctions)
        .def_property_readonly("valid", &Census::valid);
    m.def(
        "take_census",
        [](const NodeLayout& layout, const py::kwargs& named) {
            Keywords<EnumerationOptions> keywords(named);
            check_groups(layout, keywords.options.filters);
            return keywords.run([&](const auto& options) { return take_census(layout, options); });
        },
        "layout"_a,
        "Count the graphs that each filter rejects, and the graphs that all filters accept.\n\nOptions: "
        "EnumerationOptions, progress\n\n>>> import fretwork\n>>> "
        "fretwork.take_census(fretwork.paper_layout()).valid\n1824\n");
    m.def("census_csv", &census_csv, "census"_a, "The census as CSV.");
    Record<Rejection>(m, "Rejection", "A rejected graph, and the verdict that rejects it.")
        .constant("pattern", &Rejection::pattern, "")
        .constant("verdict", &Rejection::verdict, "")
        .done(Made::ByFunctions);
    m.def(
        "find_rejections",
        [](const NodeLayout& layout, std::size_t per_filter, const py::kwargs& named) {
            Keywords<EnumerationOptions> keywords(named);
            check_groups(layout, keywords.options.filters);
            return keywords.run(
                [&](const auto& options) { return find_rejections(layout, options, per_filter); });
        },
        "layout"_a, "per_filter"_a,
        "For each filter, up to `per_filter` graphs that break only its rule. For the reason why one pattern "
        "is rejected, call judge(layout, make_filters(layout, settings), pattern).\n\nOptions: "
        "EnumerationOptions, progress\n");
}

void bind_samples(py::module_& m) {
    Record<CountEstimate>(m, "CountEstimate",
                          "The number of valid patterns of a layout, estimated from random trials.")
        .constant("valid", &CountEstimate::valid, "unbiased estimate of the number")
        .constant("lower", &CountEstimate::lower,
                  "end of the interval that contains the number with the probability `confidence`")
        .constant("upper", &CountEstimate::upper, "")
        .constant("confidence", &CountEstimate::confidence, "")
        .constant("trials", &CountEstimate::trials, "")
        .constant("hits", &CountEstimate::hits, "number of trials that drew a valid pattern")
        .constant("proposals", &CountEstimate::proposals, "number of graphs from which a trial draws")
        .done(Made::ByFunctions);
    py::class_<PatternSampler>(
        m, "PatternSampler",
        "Draws valid patterns of layouts that are too large to list, each with exactly "
        "the same probability.")
        .def(py::init([](const NodeLayout& layout, std::uint64_t seed, const py::kwargs& named) {
                 Keywords<EnumerationOptions> keywords(named);
                 check_groups(layout, keywords.options.filters);
                 return PatternSampler(layout, keywords.options, seed);
             }),
             "layout"_a, "seed"_a, "Options: EnumerationOptions\n")
        .def("draw", &PatternSampler::draw, "count"_a, "most_trials"_a = std::uint64_t{100'000'000},
             py::call_guard<py::gil_scoped_release>(),
             "The next patterns; a pattern may be drawn more than once.")
        .def("estimate", &PatternSampler::estimate, "trials"_a, py::call_guard<py::gil_scoped_release>(),
             "Estimate the number of valid patterns from additional trials.");
}

void bind_sameness(py::module_& m) {
    bind_enum<Symmetry>(m);
    Record<PatternSameness>(m, "PatternSameness",
                            "The relations of a pattern to the other patterns of a list.")
        .constant("symmetry", &PatternSameness::symmetry, "")
        .constant(
            "mirror_partner", &PatternSameness::mirror_partner,
            "position of the mirror image in the list; None if it is the pattern itself or not in the list")
        .constant("isomorphism_class", &PatternSameness::isomorphism_class,
                  "number of the class of patterns with isomorphic fans")
        .done(Made::ByFunctions);
    Record<SamenessOptions>(m, "SamenessOptions", "Options of find_sameness().")
        .field("threads", &SamenessOptions::threads, "number of threads; 0: one for each processor")
        .done();
    Record<SamenessReport>(m, "SamenessReport",
                           "Mirror images and isomorphism classes of a list of patterns.")
        .constant("of_pattern", &SamenessReport::of_pattern,
                  "one entry for each pattern, in the order of the list")
        .constant("up_to_mirror", &SamenessReport::up_to_mirror,
                  "number of patterns if a mirror pair counts once")
        .constant("up_to_isomorphism", &SamenessReport::up_to_isomorphism, "number of isomorphism classes")
        .done(Made::ByFunctions);
    m.def(
        "find_sameness",
        [](const NodeLayout& layout, const std::vector<Pattern>& patterns, const py::kwargs& named) {
            check(layout, patterns);
            return Keywords<SamenessOptions>(named).run(
                [&](const auto& options) { return find_sameness(layout, patterns, options); });
        },
        "layout"_a, "patterns"_a,
        "Find mirror images and isomorphism classes.\n\nOptions: SamenessOptions, progress\n");
    m.def(
        "sameness_csv",
        [](const NodeLayout& layout, const std::vector<Pattern>& patterns, const SamenessReport& report) {
            check(layout, patterns);
            if (report.of_pattern.size() != patterns.size())
                throw base::InputError("the report is of " + std::to_string(report.of_pattern.size()) +
                                       " patterns, and there are " + std::to_string(patterns.size()));
            return sameness_csv(layout, patterns, report);
        },
        "layout"_a, "patterns"_a, "report"_a, "The report as CSV.");
}

}  // namespace

void bind_enumeration(py::module_& m) {
    bind_filter_values(m);
    bind_filters(m);
    bind_enumeration_functions(m);
    bind_census(m);
    bind_samples(m);
    bind_sameness(m);
}

}  // namespace fretwork::python

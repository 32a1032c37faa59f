// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/pattern/enumerate.hpp>
#include <fretwork/pattern/sameness.hpp>
#include <fretwork/reduction/effective_properties.hpp>
#include <studio/document/document_json.hpp>
#include <studio/document/pattern_list.hpp>
#include <studio/solving/synced_session.hpp>

#include <cmath>
#include <map>
#include <optional>

namespace fretwork::studio {
namespace {

using base::Json;
using reduction::EffectiveProperties;

/// The largest gallery; layouts with more patterns are for the command line.
constexpr std::size_t kMostPatterns = 20'000;

Json number_or_null(double value) {
    return std::isfinite(value) ? Json(value) : Json();
}

Json stiffness_json(const Eigen::Matrix3d& tensor) {
    const Eigen::Matrix3d compliance = tensor.inverse();
    return {{"young", number_or_null(1.0 / compliance(0, 0))},
            {"shear", number_or_null(1.0 / compliance(2, 2))},
            {"poisson", number_or_null(-compliance(0, 1) / compliance(0, 0))}};
}

/// The properties of a pattern; none unless the polygon has four or six sides and each interface node a
/// beam.
std::optional<EffectiveProperties> properties_of(const pattern::NodeLayout& layout,
                                                 const pattern::Pattern& pattern,
                                                 const reduction::Setting& setting) {
    try {
        return reduction::effective_properties(layout, pattern, setting);
    } catch (const base::Error&) {
        return std::nullopt;
    }
}

std::vector<pattern::Pattern> all_patterns(const pattern::NodeLayout& layout, const base::Control& control) {
    pattern::EnumerationOptions options;
    options.edges = pattern::default_edge_range(layout);
    options.control = control;
    const auto count = pattern::count_patterns(layout, options).total();
    if (count > kMostPatterns)
        throw base::InputError("layout '" + layout.name() + "' has " + std::to_string(count) +
                               " patterns, where the gallery shows " + std::to_string(kMostPatterns) +
                               " at most");
    return pattern::enumerate_patterns(layout, options);
}

std::vector<std::optional<EffectiveProperties>> all_properties(const pattern::NodeLayout& layout,
                                                               std::span<const pattern::Pattern> patterns,
                                                               const reduction::Setting& setting,
                                                               const base::Control& control) {
    std::vector<std::optional<EffectiveProperties>> properties(patterns.size());
    base::parallel_for(patterns.size(), 0, [&](std::size_t i) {
        control.check();
        properties[i] = properties_of(layout, patterns[i], setting);
    });
    return properties;
}

/// By pattern: the distance of its best calibration from its responses. None without a library of this
/// layout: in another layout, the same id is another pattern.
std::map<std::string, double> calibration_errors(const State* state, const pattern::NodeLayout& layout) {
    std::map<std::string, double> errors;
    const auto library = state != nullptr ? open_library(*state) : std::nullopt;
    if (!library || library->layout() != layout) return errors;
    for (const library::PatternSummary& summary : library->summaries()) {
        if (summary.best_objective) errors[summary.pattern] = *summary.best_objective;
    }
    return errors;
}

pattern::NodeLayout wanted_layout(const std::string& name, const State* state) {
    const bool is_own = state != nullptr && state->ground->layout.name() == name;
    return is_own ? state->ground->layout : pattern::find_node_layout(name);
}

}  // namespace

Json pattern_list(const std::string& layout_name, const State* state, const base::Control& control) {
    const pattern::NodeLayout layout = wanted_layout(layout_name, state);
    const reduction::Setting setting = state != nullptr ? *state->setting : reduction::made_setting();
    const auto patterns = all_patterns(layout, control);
    const auto sameness = pattern::find_sameness(layout, patterns, {.threads = 1, .control = control});
    const auto properties = all_properties(layout, patterns, setting, control);
    const auto errors = calibration_errors(state, layout);
    Json list = Json::array();
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        const std::string id = pattern::pattern_id(layout, patterns[i]);
        const auto& known = properties[i];
        const auto error = errors.find(id);
        const bool is_mirror = sameness.of_pattern[i].symmetry == pattern::Symmetry::Mirror;
        list.push_back({{"id", id},
                        {"edges", patterns[i].edge_count()},
                        {"mass", base::or_null(known, &EffectiveProperties::mass_per_area)},
                        {"membrane", known ? stiffness_json(known->A) : Json()},
                        {"bending", known ? stiffness_json(known->D) : Json()},
                        {"symmetry", is_mirror ? "mirror" : "none"},
                        {"error", error == errors.end() ? Json() : Json(error->second)}});
    }
    return {{"layout", layout.name()}, {"nodes", layout_nodes_json(layout)}, {"patterns", std::move(list)}};
}

}  // namespace fretwork::studio

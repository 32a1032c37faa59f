// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/design/design_words.hpp>

#include <algorithm>
#include <optional>

namespace fretwork::design {
namespace {

std::string short_number(double value) {
    return base::format_number(value, 3);
}

bool has_loads(const DesignReport& report) {
    return std::ranges::any_of(report.project.load_cases, [&](const simulation::LoadCase& own) {
        return std::ranges::find(report.load_cases, own.name) != report.load_cases.end() &&
               (!own.loads.empty() || !own.area_loads.empty() || !own.combines.empty());
    });
}

std::string single_pattern(const DesignReport& report, const std::string& which) {
    return report.uniform_tried == 1 ? "the one single pattern tried"
                                     : "the " + which + " of the " + std::to_string(report.uniform_tried) +
                                           " single patterns tried";
}

std::string times_of(const DesignReport& report, double times, const std::string& which) {
    return "the target asks for " + short_number(times) + " times the displacement of " +
           single_pattern(report, which) + ": ";
}

DesignWarning too_small(const DesignReport& report, bool factor_may_help) {
    const std::string line = times_of(report, report.wanted_of_softest, "softest");
    if (!report.reach_of_ten_loads) return {line + "what moves it is too small", factor_may_help};
    if (*report.reach_of_ten_loads >= 1.0)
        return {line + "the load is too small for it, ten times the load would do", factor_may_help};
    return {line + "even ten times the load displaces it by " +
            short_number(100.0 * *report.reach_of_ten_loads) + " % of what is wanted only"};
}

/// A load that does not fit the target. The survey is of the given loads: it says nothing of those that the
/// search chooses.
std::optional<DesignWarning> load_warning(const DesignReport& report, const DesignOptions& options) {
    if (report.nothing_moves)
        return DesignWarning{
            "nothing moves under the load case: it has no load that acts, and moves no support"};
    if (options.free_factor || options.free_prescribed) return std::nullopt;
    const bool factor_may_help = has_loads(report);
    if (report.wanted_of_softest > kLoadTooSmall) return too_small(report, factor_may_help);
    if (report.wanted_of_stiffest > 0.0 && report.wanted_of_stiffest < kLoadTooLarge)
        return DesignWarning{
            times_of(report, report.wanted_of_stiffest, "stiffest") + "what moves it is too large",
            factor_may_help};
    return std::nullopt;
}

std::string mass_line(const DesignReport& report, const DesignOptions& options) {
    return "no painting that was checked weighs at most " + short_number(options.max_mass) +
           " kg: the one that was written weighs " + base::format_number(report.mass, 4) + " kg";
}

std::string clearance_line(std::size_t pairs) {
    return "no painting that was checked keeps the clearance: " + base::counted(pairs, "pair") +
           " of bars of the one that was written " + (pairs == 1 ? "does" : "do") + " not";
}

std::string utilization_line(const DesignReport& report, const DesignOptions& options) {
    const std::string limit = short_number(options.max_utilization);
    if (!report.largest_utilization)
        return "it is not known whether the utilization stays below " + limit +
               ": no painting was checked with all beams";
    const std::string line = "no painting that was checked keeps the utilization below " + limit +
                             ": that of the one that was written is " +
                             short_number(*report.largest_utilization);
    return report.utilization_error ? line + ", with an estimated error of " +
                                          short_number(*report.utilization_error) + " by one element a beam"
                                    : line + ", and its error by one element a beam is not known";
}

}  // namespace

std::string_view design_end_words(DesignEnd end) {
    switch (end) {
        case DesignEnd::NoSwapImproves:
            return "the search found no further swap that improves it";
        case DesignEnd::SolutionsSpent:
            return "the solutions were spent";
        case DesignEnd::TimeSpent:
            return "the time was spent";
        case DesignEnd::Unreachable:
            return "no painting comes near: it was not searched";
        default:
            return "it was stopped: this is the best painting so far";
    }
}

std::vector<DesignWarning> design_warnings(const DesignReport& report, const DesignOptions& options) {
    std::vector<DesignWarning> warnings;
    if (auto load = load_warning(report, options)) warnings.push_back(std::move(*load));
    warnings.insert(warnings.end(), report.warnings.begin(), report.warnings.end());
    if (report.end == DesignEnd::Unreachable)
        warnings.push_back({"the target is out of reach: no painting of these patterns comes nearer than " +
                            short_number(100.0 * report.bound.value_or(0.0)) +
                            " % of the largest displacement wanted (root mean square, in linear theory)"});
    if (!report.keeps_mass(options)) warnings.push_back({mass_line(report, options)});
    if (!report.keeps_utilization(options)) warnings.push_back({utilization_line(report, options)});
    if (report.close_bars > 0) warnings.push_back({clearance_line(report.close_bars)});
    return warnings;
}

}  // namespace fretwork::design

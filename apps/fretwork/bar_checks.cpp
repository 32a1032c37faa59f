// SPDX-License-Identifier: GPL-3.0-or-later
#include "bar_checks.hpp"
#include "options/checks.hpp"
#include "output.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/simulation/results/bar_clearance.hpp>
#include <fretwork/simulation/surface.hpp>

#include <string_view>
#include <utility>

namespace fretwork::app {

void add_clearance_option(CLI::App& verb, std::string& clearance) {
    verb.add_option("--clearance", clearance,
                    "Warn of gaps between bars that are smaller than this, such as 0.5mm (default: 0, which "
                    "warns of overlaps)")
        ->check(length_check());
}

void warn_of_close_bars(const simulation::Project& project, const library::Library* library,
                        const std::string& clearance) {
    simulation::Surface surface = simulation::make_surface(project, nullptr);
    if (library != nullptr && !project.setting) surface.setting = library->setting();
    const auto close =
        simulation::close_bars(surface, clearance.empty() ? 0.0 : base::parse_length(clearance));
    if (!close.empty()) warn(simulation::close_bars_text(close));
}

double parse_strength(const std::string& text) {
    constexpr std::pair<std::string_view, double> kUnits[] = {
        {"GPa", 1e9}, {"MPa", 1e6}, {"kPa", 1e3}, {"Pa", 1.0}, {"", 1.0}};
    for (const auto& [unit, factor] : kUnits) {
        if (!text.ends_with(unit)) continue;
        const auto number = base::read_number<double>(text.substr(0, text.size() - unit.size()));
        if (!number || !(*number > 0) || !(*number < 1e15)) break;
        constexpr double kLeast = 1e3;  // Pa; foams bear more
        if (factor * *number < kLeast)
            throw base::InputError("--strength", "",
                                   "'" + text + "' is less than any material bears; did you mean " +
                                       text.substr(0, text.size() - unit.size()) + "MPa?");
        return factor * *number;
    }
    throw base::InputError("--strength", "", "'" + text + "' is not a strength, such as 40MPa");
}

}  // namespace fretwork::app

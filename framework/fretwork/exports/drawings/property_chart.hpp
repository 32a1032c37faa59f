// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/borrowed.hpp>
#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/pattern/pattern.hpp>
#include <fretwork/reduction/scenarios/setting.hpp>

#include <map>
#include <span>
#include <string>

namespace fretwork::exports {

/// A pattern with its effective properties, named as in reduction::property_values().
struct PatternProperties {
    pattern::Pattern pattern;                ///< the pattern
    std::map<std::string, double> values{};  ///< value of each property by its name, SI
};

/// The layout and setting of a chart's patterns, for the axes and drawings of the chart.
struct ChartSubject {
    base::Borrowed<pattern::NodeLayout> layout;  ///< node layout of the patterns
    base::Borrowed<reduction::Setting> setting;  ///< setting of the properties
};

/// A property chart as SVG, after [Ashby2011], in two panels with logarithmic axes: in-plane stiffness
/// against mass per area, and bending stiffness against in-plane stiffness. Each point is a pattern; its
/// colour is the in-plane Poisson's ratio. A point under the mouse pointer shows its pattern and properties.
/// The extreme patterns are marked by letters and drawn below the panels. Throws InputError if there are no
/// patterns, or if a pattern lacks a property; NumericalError if a stiffness or mass is not above zero.
std::string property_chart_svg(const ChartSubject& subject, std::span<const PatternProperties> patterns);

}  // namespace fretwork::exports

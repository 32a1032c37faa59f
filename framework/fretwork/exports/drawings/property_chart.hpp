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

/// A pattern and its effective properties by name: reduction::property_values.
struct PatternProperties {
    pattern::Pattern pattern;                ///< a dot of the chart
    std::map<std::string, double> values{};  ///< SI, by name
};

/// The layout and setting of a chart's patterns, for its axes and its drawings.
struct ChartSubject {
    base::Borrowed<pattern::NodeLayout> layout;  ///< of the patterns
    base::Borrowed<reduction::Setting> setting;  ///< for which the properties are
};

/// A property chart as SVG, after [Ashby2011]: in-plane stiffness over mass per area, and bending stiffness
/// over in-plane stiffness, all on logarithmic axes. Each point is a pattern, and its colour is the in-plane
/// Poisson's ratio. A point shows its pattern and properties when the mouse pointer rests on it. The extreme
/// patterns have letters and are drawn below. Throws InputError if there are no patterns or a pattern lacks a
/// property, NumericalError if a stiffness or mass is not above zero.
std::string property_chart_svg(const ChartSubject& subject, std::span<const PatternProperties> patterns);

}  // namespace fretwork::exports

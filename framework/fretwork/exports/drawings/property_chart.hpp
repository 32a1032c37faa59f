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
    pattern::Pattern pattern;
    std::map<std::string, double> values{};
};

/// Axes of a chart, and its drawings.
struct ChartSubject {
    base::Borrowed<pattern::NodeLayout> layout;
    base::Borrowed<reduction::Setting> setting;
};

/// A property chart as SVG, after [Ashby2011]: in-plane stiffness against mass per area, and bending against
/// in-plane stiffness, all on logarithmic axes; a point is a pattern, its colour the in-plane Poisson's
/// ratio. Each point names its pattern and properties where a pointer rests on it; the extreme patterns carry
/// letters and are drawn below. Throws InputError if there are no patterns or one lacks a property that is
/// drawn; NumericalError if a stiffness or mass is not above zero.
std::string property_chart_svg(const ChartSubject& subject, std::span<const PatternProperties> patterns);

}  // namespace fretwork::exports

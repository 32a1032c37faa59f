// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace fretwork::verification {

/// Points of one colour, as a line or as dots.
struct Series {
    enum class Mark { Line, Dots };
    std::string name;
    Mark mark = Mark::Line;
    std::vector<std::pair<double, double>> points;
};

/// One diagram; with logarithmic axes all numbers are above zero.
struct Panel {
    std::string title, x_label, y_label;
    bool logarithmic = false;
    bool legend_at_right = false;
    std::vector<Series> series{};
};

/// The panels side by side in rows of three, as an SVG document.
std::string plot_svg(const std::vector<Panel>& panels);

}  // namespace fretwork::verification

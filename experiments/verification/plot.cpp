// SPDX-License-Identifier: GPL-3.0-or-later
#include "plot.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace fretwork::verification {
namespace {

constexpr double kWidth = 330.0, kHeight = 280.0, kLeft = 72.0, kTop = 30.0, kRight = 12.0, kBottom = 50.0;
/// Three panels are as wide as a page, 177 mm: 6 pt are 11.84 pixels.
constexpr double kText = 12.2, kLine = 15.0;
constexpr std::size_t kPanelsInRow = 3;
constexpr const char* kColours[] = {"#1f5fa8", "#c8442e", "#3a8a4d", "#8457a6", "#b07d1f"};

/// With four digits, and small powers of ten as powers; thousands are parted.
std::string number(double value) {
    char text[32];
    const double power = value > 0.0 ? std::round(std::log10(value)) : 0.0;
    if (power <= -4.0 && std::abs(value / std::pow(10.0, power) - 1.0) < 1e-9) {
        constexpr const char* kRaised[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                           "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
        std::snprintf(text, sizeof text, "%.0f", -power);
        std::string raised = "10\u207b";
        for (const char* digit = text; *digit != '\0'; ++digit) raised += kRaised[*digit - '0'];
        return raised;
    }
    if (std::abs(value) < 1e4) {
        std::snprintf(text, sizeof text, "%.4g", value);
        return text;
    }
    std::snprintf(text, sizeof text, "%.0f", value);
    std::string digits = text;
    for (int at = static_cast<int>(digits.size()) - 3; at > (value < 0.0 ? 1 : 0); at -= 3)
        digits.insert(static_cast<std::size_t>(at), "\u2009");
    return digits;
}

std::string coordinate(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
}

/// From values to pixels along one axis.
class Axis {
  public:
    Axis(bool logarithmic, double from, double to) : logarithmic_(logarithmic), from_(from), to_(to) {}
    void include(double value) {
        low_ = std::min(low_, scaled(value));
        high_ = std::max(high_, scaled(value));
    }
    [[nodiscard]] double place(double value) const {
        const double span = high_ > low_ ? high_ - low_ : 1.0;
        return from_ + (to_ - from_) * (0.04 + 0.92 * (scaled(value) - low_) / span);
    }
    /// Powers of ten, or about five round numbers.
    [[nodiscard]] std::vector<double> ticks() const {
        std::vector<double> result;
        const double span = std::max(high_ - low_, 1e-300);
        double step = logarithmic_ ? 1.0 : std::pow(10.0, std::floor(std::log10(span / 4.0)));
        while (span / step > 6.0) step *= step * 2.0 * 4.0 < span || logarithmic_ ? 2.0 : 2.5;
        for (double tick = std::ceil(low_ / step) * step; tick <= high_ + 1e-9 * span; tick += step)
            result.push_back(logarithmic_ ? std::pow(10.0, tick) : std::abs(tick) < 1e-9 * span ? 0.0 : tick);
        return result;
    }

  private:
    [[nodiscard]] double scaled(double value) const { return logarithmic_ ? std::log10(value) : value; }
    bool logarithmic_;
    double from_, to_;
    double low_ = std::numeric_limits<double>::max();
    double high_ = std::numeric_limits<double>::lowest();
};

std::string text_at(double x, double y, const std::string& anchor, const std::string& text) {
    return "<text x=\"" + coordinate(x) + "\" y=\"" + coordinate(y) + "\" text-anchor=\"" + anchor + "\">" +
           text + "</text>\n";
}

std::string draw_ticks(const Axis& x, const Axis& y) {
    std::string svg;
    for (const double tick : x.ticks()) {
        svg += "<path d=\"M" + coordinate(x.place(tick)) + " " + coordinate(kTop) + "V" +
               coordinate(kHeight - kBottom) + "\" stroke=\"#ddd\"/>\n";
        svg += text_at(x.place(tick), kHeight - kBottom + 16.0, "middle", number(tick));
    }
    for (const double tick : y.ticks()) {
        svg += "<path d=\"M" + coordinate(kLeft) + " " + coordinate(y.place(tick)) + "H" +
               coordinate(kWidth - kRight) + "\" stroke=\"#ddd\"/>\n";
        svg += text_at(kLeft - 5.0, y.place(tick) + 4.0, "end", number(tick));
    }
    return svg;
}

std::string draw_series(const Series& series, const std::string& colour, const Axis& x, const Axis& y) {
    std::string svg;
    if (series.mark == Series::Mark::Dots) {
        for (const auto& [a, b] : series.points)
            svg += "<circle cx=\"" + coordinate(x.place(a)) + "\" cy=\"" + coordinate(y.place(b)) +
                   "\" r=\"3\" fill=\"none\" stroke-width=\"1.5\" stroke=\"" + colour + "\"/>\n";
        return svg;
    }
    svg = "<polyline fill=\"none\" stroke-width=\"1.5\" stroke=\"" + colour + "\" points=\"";
    for (const auto& [a, b] : series.points)
        svg += coordinate(x.place(a)) + "," + coordinate(y.place(b)) + " ";
    return svg + "\"/>\n";
}

std::string draw(const Panel& panel) {
    Axis x(panel.logarithmic, kLeft, kWidth - kRight);
    Axis y(panel.logarithmic, kHeight - kBottom, kTop);
    for (const Series& series : panel.series) {
        for (const auto& [a, b] : series.points) {
            x.include(a);
            y.include(b);
        }
    }
    std::string svg = draw_ticks(x, y);
    svg += text_at(kLeft, 18.0, "start", "<tspan font-weight=\"bold\">" + panel.title + "</tspan>");
    svg += text_at(0.5 * (kLeft + kWidth - kRight), kHeight - 10.0, "middle", panel.x_label);
    svg += "<text transform=\"translate(14 " + coordinate(0.5 * (kTop + kHeight - kBottom)) +
           ") rotate(-90)\" text-anchor=\"middle\">" + panel.y_label + "</text>\n";
    double line = kTop + 14.0;
    for (std::size_t i = 0; i < panel.series.size(); ++i) {
        const std::string colour = kColours[i % std::size(kColours)];
        svg += draw_series(panel.series[i], colour, x, y);
        if (panel.series[i].name.empty()) continue;
        const double x_text = panel.legend_at_right ? kWidth - kRight - 8.0 : kLeft + 8.0;
        svg += "<g fill=\"" + colour + "\">" +
               text_at(x_text, line, panel.legend_at_right ? "end" : "start", panel.series[i].name) +
               "</g>\n";
        line += kLine;
    }
    return svg;
}

}  // namespace

std::string plot_svg(const std::vector<Panel>& panels) {
    const auto rows = (panels.size() + kPanelsInRow - 1) / kPanelsInRow;
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
                      coordinate(kWidth * static_cast<double>(kPanelsInRow)) + "\" height=\"" +
                      coordinate(kHeight * static_cast<double>(rows)) +
                      "\" data-print-width=\"177mm\" font-family=\"DejaVu Sans, sans-serif\" font-size=\"" +
                      coordinate(kText) +
                      "\">\n"
                      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const std::size_t column = i % kPanelsInRow;
        const std::size_t row = i / kPanelsInRow;
        svg += "<g transform=\"translate(" + coordinate(kWidth * static_cast<double>(column)) + " " +
               coordinate(kHeight * static_cast<double>(row)) + ")\">\n" + draw(panels[i]) + "</g>\n";
    }
    return svg + "</svg>\n";
}

}  // namespace fretwork::verification

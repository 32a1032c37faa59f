// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/exports/colours.hpp>
#include <fretwork/exports/drawings/detail/chart_svg.hpp>
#include <fretwork/exports/drawings/detail/print.hpp>
#include <fretwork/exports/drawings/property_chart.hpp>
#include <fretwork/exports/tables/library_meshes.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

namespace fretwork::exports {
namespace {

using detail::kGrid;
using detail::kInk;
using detail::line;
using detail::LogAxis;
using detail::number;
using detail::px;
using detail::text;
using detail::tick_text;
using detail::wrapped;
using geometry::Point2;

// All in pixels.
constexpr double kWidth = 1620.0;
/// The chart is printed as wide as a page.
constexpr double kTextSize = detail::legible_height(kWidth, detail::kPageWidth);
constexpr double kLine = 1.2 * kTextSize;
constexpr double kPanelSize = 590.0;
constexpr double kTop = 132.0;
constexpr double kLeft = 124.0;
constexpr double kPanelGap = 140.0;
constexpr double kBarLeft = kLeft + 2.0 * kPanelSize + kPanelGap + 28.0;
constexpr double kDrawingTop = kTop + kPanelSize + 104.0;
constexpr double kDrawingStep = 187.0;
constexpr double kDrawingRadius = 70.0;
constexpr std::size_t kDrawingText = 15;  // characters in a line below a drawing

double value_of(const PatternProperties& entry, const std::string& name) {
    const auto found = entry.values.find(name);
    if (found == entry.values.end()) throw base::InputError("a pattern has no property " + name);
    return found->second;
}

/// A pattern with an extreme value of one or more properties.
struct Extreme {
    std::string reason;
    std::size_t index;                ///< of the pattern
    std::vector<std::string> rows{};  ///< below its drawing: the reason, then the id
    std::size_t reason_rows = 0;      ///< how many of them are the reason
};

/// The patterns with an extreme property or ratio of properties. Each pattern is listed once.
std::vector<Extreme> find_extremes(std::span<const PatternProperties> patterns) {
    using Score = std::function<double(const PatternProperties&)>;
    const auto of = [](const char* name, double sign = 1.0) -> Score {
        return [name, sign](const PatternProperties& p) { return sign * value_of(p, name); };
    };
    const auto ratio = [](const char* over, const char* under, double sign = 1.0) -> Score {
        return [over, under, sign](const PatternProperties& p) {
            return sign * value_of(p, over) / value_of(p, under);
        };
    };
    const std::pair<const char*, Score> rows[] = {
        {"stiffest in plane for its mass", ratio("membrane_stiffness", "mass_per_area")},
        {"softest in plane", of("membrane_stiffness", -1.0)},
        {"stiffest in bending for its mass", ratio("bending_stiffness", "mass_per_area")},
        {"softest in bending", of("bending_stiffness", -1.0)},
        {"lightest", of("mass_per_area", -1.0)},
        {"most auxetic", of("membrane_poisson", -1.0)},
        {"largest Poisson's ratio", of("membrane_poisson")},
        {"stiffest in bending for its stiffness in plane", ratio("bending_stiffness", "membrane_stiffness")},
    };
    std::vector<Extreme> extremes;
    for (const auto& [reason, score] : rows) {
        const auto best = std::ranges::max_element(patterns, {}, score);
        const std::size_t index = best - patterns.begin();
        const auto same = std::ranges::find(extremes, index, &Extreme::index);
        if (same == extremes.end()) {
            extremes.push_back({reason, index});
        } else {
            same->reason += "; " + std::string(reason);
        }
    }
    return extremes;
}

std::string letter(std::size_t extreme) {
    return std::string(1, static_cast<char>('A' + extreme));
}

/// Poisson's ratio of a plane lies between -1 and 1.
double poisson_share(double ratio) {
    return (ratio + 1.0) / 2.0;
}

class Chart {
  public:
    Chart(const ChartSubject& subject, std::span<const PatternProperties> patterns)
        : subject_(subject), patterns_(patterns), extremes_(find_extremes(patterns)) {
        for (Extreme& it : extremes_) {
            it.rows = wrapped(it.reason, kDrawingText);
            it.reason_rows = it.rows.size();
            for (std::string& part :
                 wrapped(pattern_id(subject.layout, patterns[it.index].pattern), kDrawingText))
                it.rows.push_back(std::move(part));
            most_rows_ = std::max(most_rows_, it.rows.size());
        }
    }

    std::string document() {
        body_ += text({kLeft, 40.0}, std::to_string(patterns_.size()) + " patterns as endless plates",
                      {24.0, "start", " font-weight=\"bold\""});
        body_ += text({kLeft, 70.0}, setting_line(), {kTextSize, "start"});
        body_ += text({kLeft, 70.0 + kLine}, "Rest the pointer on a point for its pattern.",
                      {kTextSize, "start", " fill=\"#6b7280\""});
        draw_panel(kLeft, axis("mass_per_area", "mass per area, kg/m²"),
                   axis("membrane_stiffness", "in-plane stiffness, N/m"),
                   {"mass_per_area", "membrane_stiffness"});
        draw_panel(kLeft + kPanelSize + kPanelGap, axis("membrane_stiffness", "in-plane stiffness, N/m"),
                   axis("bending_stiffness", "bending stiffness, N m"),
                   {"membrane_stiffness", "bending_stiffness"});
        draw_colour_bar();
        for (std::size_t i = 0; i < extremes_.size(); ++i) draw_pattern(i);
        const double height =
            kDrawingTop + 2.0 * kDrawingRadius + 12.0 + kLine * static_cast<double>(most_rows_);
        return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
               "width=\"" +
               px(kWidth) + "\" height=\"" + px(height) + "\" viewBox=\"0 0 " + px(kWidth) + " " +
               px(height) + "\" data-print-width=\"" + px(1e3 * detail::kPageWidth) +
               "mm\" font-family=\"DejaVu Sans, sans-serif\" fill=\"" + kInk +
               "\">\n<title>Property chart of patterns</title>\n<rect width=\"100%\" height=\"100%\" "
               "fill=\"#ffffff\"/>\n" +
               body_ + "</svg>\n";
    }

  private:
    /// The properties on a panel's axes, across and up.
    struct Names {
        const char* across;
        const char* up;
    };

    [[nodiscard]] std::string setting_line() const {
        const reduction::Setting& s = subject_.setting;
        return "layout " + subject_.layout->name() + ", tile side " + number(1e3 * s.tile_side) +
               " mm, bar area " + number(1e6 * s.section.area) +
               " mm², E = " + number(1e-9 * s.material.young_modulus) + " GPa, density " +
               number(s.material.density) + " kg/m³; small displacements";
    }

    [[nodiscard]] LogAxis axis(const char* name, const char* label) const {
        std::vector<double> values;
        for (const PatternProperties& entry : patterns_) values.push_back(value_of(entry, name));
        return detail::axis_of(label, values);
    }

    void draw_panel(double left, const LogAxis& across, const LogAxis& up, const Names& names) {
        const double bottom = kTop + kPanelSize;
        for (const double tick : across.ticks()) {
            const double x = left + kPanelSize * across.share(tick);
            body_ +=
                line({x, kTop}, {x, bottom}, kGrid) + text({x, bottom + 26.0}, tick_text(tick), {kTextSize});
        }
        for (const double tick : up.ticks()) {
            const double y = bottom - kPanelSize * up.share(tick);
            body_ += line({left, y}, {left + kPanelSize, y}, kGrid) +
                     text({left - 8.0, y + 7.0}, tick_text(tick), {kTextSize, "end"});
        }
        body_ += "<rect x=\"" + px(left) + "\" y=\"" + px(kTop) + "\" width=\"" + px(kPanelSize) +
                 "\" height=\"" + px(kPanelSize) + "\" fill=\"none\" stroke=\"" + kInk + "\"/>\n";
        body_ += text({left + kPanelSize / 2.0, bottom + 56.0}, across.label, {1.1 * kTextSize});
        const double x = left - 100.0;
        const double y = kTop + kPanelSize / 2.0;
        const std::string turned = " transform=\"rotate(-90 " + px(x) + " " + px(y) + ")\"";
        body_ += text({x, y}, up.label, {1.1 * kTextSize, "middle", turned});
        const auto place = [&](const PatternProperties& entry) {
            return Point2{left + kPanelSize * across.share(value_of(entry, names.across)),
                          bottom - kPanelSize * up.share(value_of(entry, names.up))};
        };
        for (const PatternProperties& entry : patterns_) draw_point(entry, place(entry));
        for (std::size_t i = 0; i < extremes_.size(); ++i)
            draw_mark(letter(i), place(patterns_[extremes_[i].index]));
    }

    void draw_point(const PatternProperties& entry, const Point2& at) {
        const double poisson = value_of(entry, "membrane_poisson");
        body_ += "<circle cx=\"" + px(at.x) + "\" cy=\"" + px(at.y) + "\" r=\"3\" fill=\"" +
                 scale_colour(poisson_share(poisson)) + "\" stroke=\"#ffffff\" stroke-width=\"0.5\"><title>" +
                 pattern_id(subject_.layout, entry.pattern) + "\nmass per area " +
                 number(value_of(entry, "mass_per_area")) + " kg/m²\nin-plane stiffness " +
                 number(value_of(entry, "membrane_stiffness")) + " N/m, Poisson's ratio " + number(poisson) +
                 "\nbending stiffness " + number(value_of(entry, "bending_stiffness")) +
                 " N m</title></circle>\n";
    }

    /// A ring around a point, and a letter beside it that is legible on other points.
    void draw_mark(const std::string& name, const Point2& at) {
        body_ += "<circle cx=\"" + px(at.x) + "\" cy=\"" + px(at.y) +
                 "\" r=\"6\" fill=\"none\" stroke=\"#d7301f\" stroke-width=\"1.8\"/>\n";
        body_ += text({at.x + 9.0, at.y - 7.0}, name,
                      {1.1 * kTextSize, "start",
                       " font-weight=\"bold\" fill=\"#b30000\" stroke=\"#ffffff\" stroke-width=\"3\" "
                       "paint-order=\"stroke\""});
    }

    void draw_colour_bar() {
        constexpr int kSteps = 64;
        constexpr double kBarWidth = 22.0;
        const double step = kPanelSize / kSteps;
        for (int i = 0; i < kSteps; ++i) {
            body_ += "<rect x=\"" + px(kBarLeft) + "\" y=\"" + px(kTop + kPanelSize - (i + 1) * step) +
                     "\" width=\"" + px(kBarWidth) + "\" height=\"" + px(step + 0.5) + "\" fill=\"" +
                     scale_colour((i + 0.5) / kSteps) + "\"/>\n";
        }
        for (const double ratio : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
            const double y = kTop + kPanelSize * (1.0 - poisson_share(ratio));
            body_ += line({kBarLeft + kBarWidth, y}, {kBarLeft + kBarWidth + 5.0, y}, kInk) +
                     text({kBarLeft + kBarWidth + 10.0, y + 7.0}, number(ratio), {kTextSize, "start"});
        }
        body_ += text({kWidth - 6.0, kTop - 14.0}, "in-plane Poisson's ratio", {kTextSize, "end"});
    }

    /// One of the extreme patterns in its tile, with its letter, why it is here, and its id.
    void draw_pattern(std::size_t extreme) {
        const Extreme& it = extremes_[extreme];
        const PatternProperties& entry = patterns_[it.index];
        const double x = kLeft + kDrawingRadius + static_cast<double>(extreme) * kDrawingStep;
        const double y = kDrawingTop + kDrawingRadius;
        const reduction::Setting& setting = subject_.setting;
        const double scale =
            kDrawingRadius / (setting.tile_side / 2.0 / std::sin(std::numbers::pi / setting.sides));
        const LineSet lines = pattern_lines(subject_.layout, entry.pattern, setting);
        std::string path;
        for (const auto& beam : lines.lines) {
            const Eigen::Vector3d from = scale * lines.nodes[beam[0]];
            const Eigen::Vector3d to = scale * lines.nodes[beam[1]];
            path +=
                "M" + px(x + from.x()) + " " + px(y - from.y()) + "L" + px(x + to.x()) + " " + px(y - to.y());
        }
        body_ += "<path d=\"" + rim(x, y) + "\" fill=\"#f4f6f8\" stroke=\"#b8c0c8\"/>\n<path d=\"" + path +
                 "\" fill=\"none\" stroke=\"#22303c\" stroke-width=\"2.4\" stroke-linecap=\"round\"/>\n";
        body_ += text({x - kDrawingRadius, kDrawingTop + 14.0}, letter(extreme),
                      {1.2 * kTextSize, "start", " font-weight=\"bold\" fill=\"#b30000\""});
        double row = kDrawingTop + 2.0 * kDrawingRadius + kLine;
        for (std::size_t i = 0; i < it.rows.size(); ++i) {
            const char* fill = i < it.reason_rows ? "" : " fill=\"#6b7280\"";
            body_ += text({x, row}, it.rows[i], {kTextSize, "middle", fill});
            row += kLine;
        }
    }

    [[nodiscard]] std::string rim(double x, double y) const {
        std::string path;
        const geometry::Polygon polygon = geometry::regular_polygon(
            subject_.setting->sides,
            2.0 * kDrawingRadius * std::sin(std::numbers::pi / subject_.setting->sides));
        for (const Point2& corner : polygon)
            path += (path.empty() ? "M" : "L") + px(x + corner.x) + " " + px(y - corner.y);
        return path + "Z";
    }

    const ChartSubject& subject_;
    std::span<const PatternProperties> patterns_;
    std::vector<Extreme> extremes_;
    std::size_t most_rows_ = 0;
    std::string body_;
};

}  // namespace

std::string property_chart_svg(const ChartSubject& subject, std::span<const PatternProperties> patterns) {
    if (patterns.empty()) throw base::InputError("there is no pattern with properties to chart");
    return Chart(subject, patterns).document();
}

}  // namespace fretwork::exports

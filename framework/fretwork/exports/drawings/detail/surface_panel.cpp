// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/exports/colours.hpp>
#include <fretwork/exports/drawings/detail/fan_drawing.hpp>
#include <fretwork/exports/drawings/detail/furniture.hpp>
#include <fretwork/exports/drawings/detail/panels.hpp>
#include <fretwork/exports/drawings/detail/surface_parts.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace fretwork::exports::detail {
namespace {

using geometry::Box;

std::string force_text(double newtons) {
    return newtons < 0.1 ? short_number(1e3 * newtons) + " mN" : short_number(newtons) + " N";
}

using geometry::Point2;
using simulation::Conditions;
using simulation::Surface;

/// An id in lines of about `length` characters, parted where edges are.
std::vector<std::string> id_lines(const std::string& id, std::size_t length) {
    std::vector<std::string> lines(1);
    for (const std::string& edge : base::split(id, '+')) {
        std::string& last = lines.back();
        if (last.empty())
            last = edge;
        else if (last.size() + 1 + edge.size() <= length)
            last += "+" + edge;
        else
            lines.push_back("+" + edge);
    }
    return lines;
}

/// The patterns in use in columns: a small fan, its colour, its id.
class PatternLegend {
  public:
    PatternLegend(const Surface& surface, double width)
        : surface_(&surface), used_(tiling::used_patterns(surface.tessellation)), text_(text_height(width)) {
        std::size_t longest = 1;
        for (const std::size_t pattern : used_) {
            ids_.push_back(id_lines(surface.tessellation.patterns[pattern].id, kLineLength));
            most_lines_ = std::max(most_lines_, static_cast<int>(ids_.back().size()));
            for (const std::string& line : ids_.back()) longest = std::max(longest, line.size());
        }
        column_width_ = 5.0 * text_ + text_width(std::string(longest, ' '), text_);
        columns_ = std::max(1, static_cast<int>(width / column_width_));
    }
    [[nodiscard]] double height() const {
        const int rows = (static_cast<int>(ids_.size()) + columns_ - 1) / columns_;
        return row_height() * rows;
    }
    void draw(SvgCanvas& canvas, const Point2& top_left) const {
        canvas.layer("legend of patterns");
        for (int i = 0; i < static_cast<int>(ids_.size()); ++i) {
            const int row = i / columns_;
            const Point2 middle{top_left.x + (i % columns_) * column_width_ + 1.7 * text_,
                                top_left.y - (row + 0.5) * row_height()};
            draw_icon(canvas, used_[i], middle);
            draw_id(canvas, ids_[i], {middle.x + 2.2 * text_, middle.y});
        }
    }

  private:
    static constexpr std::size_t kLineLength = 16;  // four edges: ids of up to twelve are as high as a fan

    [[nodiscard]] double row_height() const { return std::max(3.5, 1.2 * most_lines_ + 0.4) * text_; }

    void draw_id(SvgCanvas& canvas, const std::vector<std::string>& lines, const Point2& middle) const {
        double y = middle.y + (0.6 * static_cast<double>(lines.size() - 1) - 0.35) * text_;
        for (const std::string& line : lines) {
            canvas.text({middle.x, y}, line, text_);
            y -= 1.2 * text_;
        }
    }

    void draw_icon(SvgCanvas& canvas, std::size_t pattern, const Point2& middle) const {
        const double side = 1.65 * text_;
        const geometry::Polygon hexagon = moved(geometry::regular_polygon(6, side), middle);
        canvas.polygon(hexagon, {pattern_colour(static_cast<int>(pattern)), "none", 0.0, 1.0});
        draw_fan_beams(canvas, surface_->layout, surface_->tessellation.patterns[pattern].pattern, hexagon,
                       {"none", kBeamColour, 0.06 * side, 1.0});
    }

    const Surface* surface_;
    std::vector<std::size_t> used_;
    double text_;
    std::vector<std::vector<std::string>> ids_;  // in lines
    int most_lines_ = 1;
    double column_width_ = 0.0;
    int columns_ = 1;
};

/// One line that says what balls, arrows and rings mean.
class ConditionLegend {
  public:
    ConditionLegend(const std::vector<SupportMark>& supports, const std::vector<LoadMark>& loads,
                    const Conditions& conditions)
        : drawn_loads_(loads.size()) {
        for (const LoadMark& mark : loads) shapes_.emplace(mark.kind, mark.shape);
        for (const SupportMark& mark : supports) {
            const auto same = [&](const SupportMark& other) { return other.meaning == mark.meaning; };
            if (std::ranges::none_of(supports_, same)) supports_.push_back(mark);
        }
        for (const mechanics::NodalLoad& load : conditions.loads) {
            largest_force_ = std::max(largest_force_, load.force.norm());
            largest_moment_ = std::max(largest_moment_, load.moment.norm());
            all_loads_ += (load.force.norm() > 0.0 ? 1 : 0) + (load.moment.norm() > 0.0 ? 1 : 0);
        }
    }
    void draw(SvgCanvas& canvas, Point2 place) const {
        canvas.layer("legend of conditions");
        const double text = text_height(canvas.box().width());
        for (SupportMark mark : supports_) {
            mark.place = {place.x + 0.6 * text, place.y + 0.35 * text};
            draw_support(canvas, mark, 0.6 * text);
            place = write(canvas, {place.x + 1.8 * text, place.y}, mark.meaning);
        }
        using Kind = LoadMark::Kind;
        if (largest_force_ > 0)
            place = draw_load_entries(canvas, place, Kind::Force,
                                      "forces, the largest " + force_text(largest_force_));
        if (largest_moment_ > 0)
            place =
                draw_load_entries(canvas, place, Kind::Moment,
                                  "moments, the largest " + short_number(1e3 * largest_moment_) + " N mm");
        if (drawn_loads_ < all_loads_)
            write(canvas, place,
                  std::to_string(drawn_loads_) + " of " + std::to_string(all_loads_) + " drawn");
    }

  private:
    static Point2 write(SvgCanvas& canvas, const Point2& place, const std::string& words) {
        const double text = text_height(canvas.box().width());
        canvas.text(place, words, text);
        return {place.x + text_width(words, text) + 1.5 * text, place.y};
    }
    /// The legend of the shapes that are drawn; the first row names them.
    Point2 draw_load_entries(SvgCanvas& canvas, Point2 place, LoadMark::Kind kind, std::string words) const {
        using Shape = LoadMark::Shape;
        const std::pair<Shape, const char*> kShapes[] = {{Shape::Arrow, ""},
                                                         {Shape::AwayFromViewer, "away from you"},
                                                         {Shape::TowardsViewer, "towards you"}};
        for (const auto& [shape, where] : kShapes) {
            if (!shapes_.contains({kind, shape})) continue;
            const std::string both = words + (words.empty() || *where == '\0' ? "" : ", ") + where;
            place = draw_load_entry(canvas, place, {kind, shape}, both);
            words.clear();
        }
        return place;
    }
    using ShownLoad = std::pair<LoadMark::Kind, LoadMark::Shape>;
    static Point2 draw_load_entry(SvgCanvas& canvas, const Point2& place, const ShownLoad& load,
                                  const std::string& words) {
        const double text = text_height(canvas.box().width());
        const double middle = place.y + 0.35 * text;
        const double size = 2.6 * text;
        const bool is_arrow = load.second == LoadMark::Shape::Arrow;
        const double start = place.x + (is_arrow ? 0.0 : 0.5 * text);
        draw_load(canvas, {load.first, load.second, {start, middle}, {place.x + size, middle}, size});
        return write(canvas, {place.x + (is_arrow ? 3.2 : 1.5) * text, place.y}, words);
    }

    std::size_t drawn_loads_;
    std::size_t all_loads_ = 0;
    std::set<ShownLoad> shapes_;
    std::vector<SupportMark> supports_;
    double largest_force_ = 0.0;
    double largest_moment_ = 0.0;
};

/// The surface with what is drawn on it, and the part of the plane that this takes.
struct Subject {
    Projection projection;
    std::vector<SupportMark> supports;
    std::vector<LoadMark> loads;
    Box box;
};

Subject make_subject(const Surface& surface, const Conditions* conditions, const Projection& projection,
                     double reach) {
    Subject subject{projection, {}, {}, {}};
    std::vector<Point2> points = projection.all(surface.tessellation.vertices);
    if (conditions != nullptr) {
        subject.supports = support_marks(surface, *conditions, projection);
        subject.loads = load_marks(surface, *conditions, projection, reach);
    }
    for (const LoadMark& mark : subject.loads) {
        points.push_back(mark.from);
        points.push_back(mark.to);
    }
    subject.box = bounding_box(points, 0.5 * tiling::mean_tile_side(surface.tessellation));
    return subject;
}

/// Of many marks some that are far apart: first the one nearest to the middle of all, then always the one
/// that is farthest from those that are taken.
std::vector<LoadMark> few_of(std::vector<LoadMark> marks) {
    constexpr std::size_t kMost = 32;  // more hide what is below them
    constexpr std::size_t kFew = 16;
    if (marks.size() <= kMost) return marks;
    Point2 middle;
    for (const LoadMark& mark : marks) {
        middle.x += mark.to.x / static_cast<double>(marks.size());
        middle.y += mark.to.y / static_cast<double>(marks.size());
    }
    const auto distance = [](const Point2& a, const Point2& b) { return std::hypot(a.x - b.x, a.y - b.y); };
    std::vector<double> gaps;  // of each mark to those that are taken; before the first, its nearness
    for (const LoadMark& mark : marks) gaps.push_back(-distance(mark.to, middle));
    std::vector<LoadMark> few;
    for (bool is_first = true; few.size() < kFew; is_first = false) {
        const auto next = static_cast<std::size_t>(std::ranges::max_element(gaps) - gaps.begin());
        few.push_back(marks[next]);
        for (std::size_t i = 0; i < marks.size(); ++i) {
            const double gap = distance(marks[i].to, marks[next].to);
            gaps[i] = is_first ? gap : std::min(gaps[i], gap);
        }
    }
    return few;
}

void draw_subject(SvgCanvas& canvas, const Surface& surface, const Subject& subject) {
    draw_tiles(canvas, surface, subject.projection);
    draw_beams(canvas, surface, subject.projection);
    canvas.layer("loads");
    for (const LoadMark& mark : subject.loads) draw_load(canvas, mark);
    canvas.layer("supports");
    const double radius = 0.16 * tiling::mean_tile_side(surface.tessellation);
    for (const SupportMark& mark : subject.supports) draw_support(canvas, mark, radius);
}

}  // namespace

SvgCanvas surface_panel(const Surface& surface, const Conditions* conditions, const DrawnLabels& labels) {
    const Subject subject = make_subject(surface, conditions, Projection::from_above(),
                                         1.6 * tiling::mean_tile_side(surface.tessellation));
    const double text = text_height(subject.box.width());
    const PatternLegend legend(surface, subject.box.width() - 2.0 * text);
    const double legend_top = subject.box.ymin - text;
    const double foot = legend_top - legend.height() - 3.0 * text;
    Box box = subject.box;
    box.ymin = foot - (conditions != nullptr ? 3.0 : 1.0) * text;
    SvgCanvas canvas(box, 1.0);
    draw_subject(canvas, surface, subject);
    draw_labels(canvas, surface, labels);
    legend.draw(canvas, {box.xmin + text, legend_top});
    if (conditions != nullptr)
        ConditionLegend(subject.supports, subject.loads, *conditions)
            .draw(canvas, {box.xmin + text, foot - 2.0 * text});
    canvas.layer("scale");
    draw_scale_bar(canvas, {box.xmin + text, foot + 0.6 * text});
    const double behind_bar = box.xmin + 2.0 * text + 0.2 * box.width();  // a bar is at most so long
    canvas.text({behind_bar, foot + 0.6 * text}, joints_note(surface.setting.joints), text);
    return canvas;
}

SvgCanvas reduced_panel(const Surface& surface, const LineSet& beams) {
    const Projection projection = Projection::from_above();
    const Box box = bounding_box(projection.all(surface.tessellation.vertices),
                                 0.5 * tiling::mean_tile_side(surface.tessellation));
    SvgCanvas canvas(box, 1.0);
    canvas.layer("tiles");
    const double width = beam_width(surface);
    for (std::size_t t = 0; t < surface.tessellation.tiles.size(); ++t)
        canvas.polygon(projection.all(tiling::tile_polygon(surface.tessellation, tiling::TileIndex(t))),
                       {"#f4f6f8", kRimColour, 0.2 * width, 1.0});
    canvas.layer("beams of the reduced model");
    const std::vector<Point2> nodes = projection.all(beams.nodes);
    canvas.segments(segments_of(beams.lines, nodes), {"none", kReducedColour, width, 1.0});
    return canvas;
}

SvgCanvas setup_panel(const Surface& surface, const Conditions& conditions, const ViewOptions& view) {
    Subject subject = make_subject(surface, &conditions, Projection(view),
                                   2.5 * tiling::mean_tile_side(surface.tessellation));
    subject.loads = few_of(std::move(subject.loads));
    const double text = text_height(subject.box.width());
    Box box = subject.box;
    box.ymin -= 3.0 * text;
    SvgCanvas canvas(box, 1.0);
    draw_subject(canvas, surface, subject);
    ConditionLegend(subject.supports, subject.loads, conditions)
        .draw(canvas, {box.xmin + text, box.ymin + text});
    return canvas;
}

}  // namespace fretwork::exports::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/drawings/detail/condition_legend.hpp>
#include <fretwork/exports/drawings/detail/furniture.hpp>
#include <fretwork/exports/drawings/detail/panels.hpp>
#include <fretwork/exports/drawings/detail/pattern_legend.hpp>
#include <fretwork/exports/drawings/detail/print.hpp>
#include <fretwork/exports/drawings/detail/surface_parts.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <algorithm>
#include <iterator>

namespace fretwork::exports::detail {
namespace {

using geometry::Box;
using geometry::Point2;
using simulation::Conditions;
using simulation::Surface;

/// The projection of a surface, the marks on it, and the box around both.
struct Subject {
    Projection projection;
    ConditionMarks marks;
    Box box;
};

Subject make_subject(const Surface& surface, const Conditions* conditions, const Projection& projection,
                     double reach) {
    Subject subject{projection, {}, {}};
    std::vector<Point2> points = projection.all(surface.tessellation.vertices);
    if (conditions != nullptr)
        subject.marks = {support_marks(surface, *conditions, projection),
                         prescribed_marks(surface, *conditions, projection),
                         load_marks(surface, *conditions, projection, reach)};
    for (const LoadMark& mark : subject.marks.loads) {
        points.push_back(mark.from);
        points.push_back(mark.to);
    }
    subject.box = bounding_box(points, 0.5 * tiling::mean_tile_side(surface.tessellation));
    return subject;
}

/// If there are many marks, a few that are far apart. The first is nearest to the middle of all marks, and
/// each further one is farthest from those already taken.
std::vector<LoadMark> few_of(std::vector<LoadMark> marks) {
    constexpr std::size_t kMost = 32;  // more hide what is below them
    constexpr std::size_t kFew = 16;
    if (marks.size() <= kMost) return marks;
    Point2 middle;
    for (const LoadMark& mark : marks) {
        middle.x += mark.to.x / static_cast<double>(marks.size());
        middle.y += mark.to.y / static_cast<double>(marks.size());
    }
    std::vector<double> gaps;  // from each mark to those taken; at first, its nearness to the middle
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

/// Thin out forces and moments separately, so that neither kind is lost.
std::vector<LoadMark> few_of_each_kind(const std::vector<LoadMark>& marks) {
    std::vector<LoadMark> few;
    for (const LoadMark::Kind kind : {LoadMark::Kind::Force, LoadMark::Kind::Moment}) {
        std::vector<LoadMark> of_kind;
        std::ranges::copy_if(marks, std::back_inserter(of_kind),
                             [kind](const LoadMark& mark) { return mark.kind == kind; });
        std::ranges::move(few_of(std::move(of_kind)), std::back_inserter(few));
    }
    return few;
}

void draw_subject(SvgCanvas& canvas, const Surface& surface, const Subject& subject,
                  Tint tint = Tint::Patterns) {
    draw_tiles(canvas, surface, subject.projection, tint);
    draw_beams(canvas, surface, subject.projection, tint);
    canvas.layer("loads");
    for (const LoadMark& mark : subject.marks.loads) draw_load(canvas, mark);
    canvas.layer("supports");
    const double radius =
        std::max(0.16 * tiling::mean_tile_side(surface.tessellation), 0.007 * subject.box.width());
    for (const SupportMark& mark : subject.marks.supports) draw_support(canvas, mark, radius);
    if (subject.marks.prescribed.empty()) return;
    canvas.layer("prescribed displacements");
    for (const Point2& place : subject.marks.prescribed) draw_prescribed(canvas, place, radius);
}

}  // namespace

SvgCanvas surface_panel(const Surface& surface, const Conditions* conditions, const DrawnLabels& labels) {
    const Subject subject = make_subject(surface, conditions, Projection::from_above(),
                                         1.2 * tiling::mean_tile_side(surface.tessellation));
    const double text = text_height(subject.box.width());
    const double width = subject.box.width() - 2.0 * text;
    const PatternLegend patterns(surface, width, text);
    const ConditionLegend marks(subject.marks, conditions, subject.box.width());
    const double marks_top = subject.box.ymin - text - patterns.height() - 3.0 * text;
    Box box = subject.box;
    box.ymin = marks_top - marks.height() - text;
    SvgCanvas canvas(box, 1.0);
    draw_subject(canvas, surface, subject);
    draw_labels(canvas, surface, labels);
    const double left = box.xmin + text;
    patterns.draw(canvas, {left, subject.box.ymin - text});
    if (conditions != nullptr) marks.draw(canvas, {left, marks_top - text});
    canvas.layer("scale");
    const double foot = marks_top + 0.9 * text;
    draw_scale_bar(canvas, {left, foot}, text);
    const double behind_bar = left + text + 0.2 * box.width();  // a bar is at most so long
    canvas.text({behind_bar, foot}, joints_note(surface.setting.joints), text);
    return canvas;
}

SvgCanvas tiling_panel(const Surface& surface, const DrawnLabels& labels, double text_share) {
    const Subject subject = make_subject(surface, nullptr, Projection::from_above(), 0.0);
    const double text = text_share * subject.box.width();
    Box box = subject.box;
    box.ymin -= 2.2 * text;
    SvgCanvas canvas(box, 1.0);
    draw_subject(canvas, surface, subject);
    draw_labels(canvas, surface, labels);
    canvas.layer("scale");
    draw_scale_bar(canvas, {box.xmin + text, box.ymin + 0.6 * text}, text);
    return canvas;
}

SvgCanvas reduced_panel(const Surface& surface, const LineSet& beams, double text_share) {
    const Projection projection = Projection::from_above();
    Box box = bounding_box(projection.all(surface.tessellation.vertices),
                           0.5 * tiling::mean_tile_side(surface.tessellation));
    box.ymin -= 2.2 * text_share * box.width();  // as high as the tiling beside it
    SvgCanvas canvas(box, 1.0);
    canvas.layer("tiles");
    const double width = beam_width(surface);
    for (std::size_t t = 0; t < surface.tessellation.tiles.size(); ++t)
        canvas.polygon(projection.all(tiling::tile_polygon(surface.tessellation, tiling::TileIndex(t))),
                       {"#f4f6f8", kRimColour, 0.2 * width, 1.0});
    canvas.layer("beams of the reduced model");
    const std::vector<Point2> nodes = projection.all(beams.nodes);
    canvas.segments(segments_of(beams.lines, nodes),
                    {"none", kReducedColour, std::max(width, 0.0035 * box.width()), 1.0});
    return canvas;
}

SvgCanvas setup_panel(const Surface& surface, const Conditions& conditions, const ViewOptions& view) {
    const Projection projection(view);
    const Box plain = bounding_box(projection.all(surface.tessellation.vertices), 0.0);
    const double reach = std::max(2.5 * tiling::mean_tile_side(surface.tessellation), 0.1 * plain.width());
    Subject subject = make_subject(surface, &conditions, projection, reach);
    subject.marks.loads = few_of_each_kind(subject.marks.loads);
    const double text = text_height(subject.box.width());
    const ConditionLegend marks(subject.marks, &conditions, subject.box.width());
    Box box = subject.box;
    box.ymin -= marks.height() + text;
    SvgCanvas canvas(box, 1.0);
    draw_subject(canvas, surface, subject, Tint::Pale);
    marks.draw(canvas, {box.xmin + text, subject.box.ymin - 1.5 * text});
    return canvas;
}

}  // namespace fretwork::exports::detail

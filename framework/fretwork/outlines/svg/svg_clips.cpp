// SPDX-License-Identifier: GPL-3.0-or-later
// Clips of an SVG drawing, and the boxes by which they are measured.
#include <fretwork/outlines/regions/map_parts.hpp>
#include <fretwork/outlines/svg/svg_reader.hpp>

#include <algorithm>
#include <utility>

namespace fretwork::outlines::detail {

using geometry::Polygon;

std::size_t SvgReader::add_clip(Clip clip, pugi::xml_node node) {
    const int depth = clip.outer ? clip_depths_[*clip.outer] + 1 : 1;
    if (depth > kDeepest)
        document_.fail(node, "clips lie more than " + std::to_string(kDeepest) + " deep in one another");
    clip_depths_.push_back(depth);
    std::size_t points = clip.outer ? clip_points_[*clip.outer] : 0;
    for (const FilledShape& shape : clip.shapes) {
        for (const Polygon& loop : shape.loops) points += loop.size();
        if (shape.clip) points += clip_points_[*shape.clip];
    }
    clip_points_.push_back(points);
    picture_.clips.push_back(std::move(clip));
    return picture_.clips.size() - 1;
}

void SvgReader::count_clipping(double work, pugi::xml_node node) {
    constexpr double kMostWork = 2e9;  // comparisons of points; some ten seconds
    clipping_ += work;
    if (clipping_ > kMostWork)
        document_.fail(node,
                       "up to here, clips of many points cut very many lines; release the clips in the "
                       "drawing, or simplify them");
}

std::optional<std::size_t> SvgReader::clip_of(const SvgElement& element, const Surroundings& around) {
    const std::string_view value = element.properties().find("clip-path");
    if (value.empty() || value == "none" || purpose_ == Purpose::Box) return around.clip;
    if (!value.starts_with("url(")) {
        remarks_.leave_out("clip-path without url()");
        return around.clip;
    }
    const pugi::xml_node clip = document_.referred(value);
    if (!clip || document_.name_of(clip) != "clipPath") return around.clip;
    if (std::ranges::find(copying_, clip) != copying_.end()) document_.fail(clip, "clips itself");
    return read_clip(clip, element, around);
}

std::size_t SvgReader::read_clip(pugi::xml_node clip, const SvgElement& clipped, Surroundings around) {
    enter(clip, ++around.depth);
    const SvgProperties properties(clip, document_);
    const SvgElement element(clip, properties, document_);
    copying_.push_back(clip);
    if (std::string_view(clip.attribute("clipPathUnits").value()) == "objectBoundingBox")
        around.map = around.map.after(unit_box_of(clipped, around));
    around.map = around.map.after(element.transform(around.measure));
    around.clip = clip_of(element, around);  // a clip may have a clip of its own
    around.style = style_in({}, properties, document_);
    Clip made{{}, around.clip};
    around.clip.reset();
    const auto shapes = std::exchange(shapes_, &made.shapes);
    const auto purpose = std::exchange(purpose_, Purpose::Clip);
    read_children(clip, around);
    shapes_ = shapes;
    purpose_ = purpose;
    copying_.pop_back();
    return add_clip(std::move(made), clip);
}

Affine SvgReader::unit_box_of(const SvgElement& element, const Surroundings& around) {
    document_.charge(element.node());  // it is read once more, for its box
    std::vector<FilledShape> found;
    const auto shapes = std::exchange(shapes_, &found);
    const auto purpose = std::exchange(purpose_, Purpose::Box);
    constexpr double kBoxShare = 1e-4;  // largest error of the box, as a share of the viewport
    const double tolerance =
        std::exchange(how_.tolerance, kBoxShare * std::max(around.measure.width, around.measure.height));
    Surroundings inside{.style = around.style, .measure = around.measure, .depth = around.depth};
    read_kind(document_.name_of(element.node()), element, inside);
    shapes_ = shapes;
    purpose_ = purpose;
    how_.tolerance = tolerance;
    std::vector<Polygon> loops;
    for (FilledShape& shape : found) std::ranges::move(shape.loops, std::back_inserter(loops));
    const geometry::Box box = box_of(loops);
    return {box.width(), 0, 0, box.height(), box.xmin, box.ymin};
}

}  // namespace fretwork::outlines::detail

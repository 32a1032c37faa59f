// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/fabrication/detail/assembling.hpp>
#include <fretwork/fabrication/detail/fillets.hpp>
#include <fretwork/fabrication/detail/length_text.hpp>
#include <fretwork/fabrication/shape.hpp>
#include <fretwork/geometry/box_grid.hpp>

#include <algorithm>
#include <span>

namespace fretwork::fabrication {
namespace {

/// A fillet that lacks at most this share of its radius counts as full: corners lie on a grid.
constexpr double kRounding = 0.01;

std::string share_text(std::size_t part, std::size_t all) {
    return std::to_string(part) + " of " + std::to_string(all);
}

std::vector<geometry::Polygon> openings(const Shape& shape) {
    constexpr double kOpeningTolerance = 1e-6;  // m
    std::vector<geometry::Polygon> polygons;
    for (const Piece& piece : shape.pieces)
        for (const Contour& opening : piece.openings)
            polygons.push_back(flattened(opening, kOpeningTolerance));
    return polygons;
}

/// The number of openings of `left` without an opening of `cut` inside. A difference of the numbers of
/// openings would miss some: the kerf also divides openings, and closes bays to openings.
std::size_t closed_openings(const Shape& left, const Shape& cut) {
    const std::vector<geometry::Polygon> wanted = openings(left);
    std::vector<geometry::Box> boxes;
    for (const geometry::Polygon& opening : wanted)
        boxes.push_back(geometry::box_of(std::span<const geometry::Point2>(opening)));
    if (boxes.empty()) return 0;
    const geometry::BoxGrid grid(boxes);
    std::vector<bool> is_made(wanted.size(), false);
    for (const geometry::Polygon& made : openings(cut)) {
        for (const std::size_t i : grid.meeting(geometry::box_of(std::span<const geometry::Point2>(made)))) {
            if (is_made[i]) continue;
            is_made[i] = std::ranges::any_of(
                made, [&](const geometry::Point2& point) { return detail::contains(wanted[i], point); });
        }
    }
    return static_cast<std::size_t>(std::ranges::count(is_made, false));
}

}  // namespace

std::vector<std::string> shape_remarks(const Shape& left, const Shape& cut, const ShapeOptions& options) {
    std::vector<std::string> remarks;
    if (options.kerf > 0.0) {
        const std::size_t closed = closed_openings(left, cut);
        if (closed > 0)
            remarks.push_back("the kerf of " + detail::millimetres(options.kerf) + " closes " +
                              share_text(closed, opening_count(left)) + " openings: they are not cut");
    }
    if (options.fillet > 0.0) {
        const std::vector<double> radii = detail::inner_corner_radii(left);
        const auto small = std::ranges::count_if(
            radii, [&](double radius) { return radius < (1.0 - kRounding) * options.fillet; });
        if (small > 0)
            remarks.push_back("the fillet of " + detail::millimetres(options.fillet) + " does not fit in " +
                              share_text(small, radii.size()) + " inner corners: the smallest is " +
                              detail::millimetres(std::ranges::min(radii)));
    }
    return remarks;
}

RemarkedShape make_remarked_shape(const simulation::Surface& surface, const ShapeOptions& options) {
    options.validate();
    const BarPlan plan = bar_plan(surface, options.frame_width);
    RemarkedShape made{make_shape(plan, options), {}};
    made.remarks = options.kerf > 0.0
                       ? shape_remarks(make_shape(plan, options.without_kerf()), made.shape, options)
                       : shape_remarks(made.shape, made.shape, options);
    return made;
}

}  // namespace fretwork::fabrication

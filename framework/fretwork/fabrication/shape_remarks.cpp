// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/fabrication/detail/fillets.hpp>
#include <fretwork/fabrication/detail/length_text.hpp>
#include <fretwork/fabrication/shape.hpp>

#include <algorithm>

namespace fretwork::fabrication {
namespace {

/// A fillet that lacks at most this share of its radius counts as full: corners lie on a grid.
constexpr double kRounding = 0.01;

std::string share_text(std::size_t part, std::size_t all) {
    return std::to_string(part) + " of " + std::to_string(all);
}

}  // namespace

std::vector<std::string> shape_remarks(const Shape& left, const Shape& cut, const ShapeOptions& options) {
    std::vector<std::string> remarks;
    if (options.kerf > 0.0) {
        const std::size_t made = opening_count(cut), wanted = opening_count(left);
        if (made < wanted)
            remarks.push_back("the kerf of " + detail::millimetres(options.kerf) + " closes " +
                              share_text(wanted - made, wanted) + " openings: they are not cut");
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

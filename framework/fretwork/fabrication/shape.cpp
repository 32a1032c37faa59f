// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/fabrication/detail/assembling.hpp>
#include <fretwork/fabrication/detail/clipping.hpp>
#include <fretwork/fabrication/detail/fillets.hpp>
#include <fretwork/fabrication/detail/length_text.hpp>
#include <fretwork/fabrication/detail/patches.hpp>
#include <fretwork/fabrication/detail/planar_faces.hpp>
#include <fretwork/fabrication/shape.hpp>
#include <fretwork/geometry/box_grid.hpp>
#include <fretwork/geometry/plane.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace fretwork::fabrication {
namespace {

using geometry::Box;
using geometry::Point2;

using namespace detail;
using geometry::Polygon;

void require_length(double value, const char* what) {
    if (std::isfinite(value) && value >= 0.0) return;
    throw base::InputError(std::string(what) + " is " + base::format_number(value) +
                           " m, where zero or a length above it is needed");
}

double eye_diameter(const ShapeOptions& options) {
    return options.eye_diameter > 0.0 ? options.eye_diameter : 2.0 * options.bolt_diameter;
}

/// Refuse lengths above the surface's size: they were probably meant in millimetres. Fillets need no check,
/// because they shrink until they fit.
void require_below_surface(const BarPlan& plan, const ShapeOptions& options) {
    const Box box = geometry::box_of(std::span<const Point2>(plan.nodes));
    const auto require = [&](double value, const char* what) {
        if (value < std::max(box.width(), box.height())) return;
        throw base::InputError(std::string(what) + " is " + base::format_number(value) +
                               " m, which is more than the whole surface, " +
                               base::format_number(box.width()) + " x " + base::format_number(box.height()) +
                               " m");
    };
    require(options.kerf, "the kerf");
    require(options.frame_width, "the width of the frame");
    require(options.bolt_diameter, "the diameter of holes for bolts");
    require(options.eye_diameter, "the diameter of eyes");
}

/// Refuse bars so narrow that the outline's grid would spoil them.
void require_wide_bars(const BarPlan& plan) {
    if (plan.bars.empty()) return;
    const double width = std::ranges::min(plan.bars, {}, &Bar::width).width;
    if (width >= least_width()) return;
    throw base::InputError("bars are " + millimetres(width) + " wide, where the outline needs at least " +
                           millimetres(least_width()) + ": its corners lie on a grid of nanometres");
}

/// Makes the contours around the material, region by region; the lines of the bars bound the regions. The
/// empty part of each region is computed separately, so that most Boolean operations have few edges, even in
/// large surfaces.
class ShapeMaker {
  public:
    ShapeMaker(const BarPlan& plan, const ShapeOptions& options)
        : plan_(plan), options_(options), patches_(make_patches()), grid_(boxes()) {}

    [[nodiscard]] Shape run() const {
        const std::vector<Face> faces = planar_faces(plan_);
        std::vector<std::vector<Contour>> contours(faces.size());
        base::parallel_for(faces.size(), 0, [&](std::size_t i) {
            const std::size_t f = faces.size() - 1 - i;  // the unbounded region takes longest
            options_.control.check();
            contours[f] = contours_in(faces[f]);
        });
        std::vector<Contour> all;
        for (auto& of_face : contours)
            for (Contour& contour : of_face) all.push_back(std::move(contour));
        Shape shape{assembled(all), plan_.height};
        drill(shape);
        return shape;
    }

  private:
    [[nodiscard]] Point2 place(TessellationNodeIndex node) const { return plan_.nodes[node]; }

    [[nodiscard]] std::vector<Patch> make_patches() const {
        std::vector<Patch> patches = bar_patches(plan_, options_.kerf);
        if (options_.bolt_diameter == 0.0) return patches;
        for (const TessellationNodeIndex node : options_.bolts)
            patches.push_back(disc_patch({place(node), options_.eye_radius()}));
        return patches;
    }
    [[nodiscard]] std::vector<Box> boxes() const {
        std::vector<Box> boxes;
        for (const Patch& patch : patches_) boxes.push_back(patch.box);
        return boxes;
    }

    [[nodiscard]] std::vector<Contour> contours_in(const Face& face) const {
        const bool endless = face.outer.empty();
        const Polygon whole = endless ? far_around() : face.outer;
        std::vector<Polygon> parts = face.islands;
        std::vector<Disc> discs;
        const auto add = [&](const Patch& patch) {
            parts.push_back(patch.polygon);
            if (patch.disc) discs.push_back(*patch.disc);
        };
        for (const std::size_t p : near(face)) add(patches_[p]);
        std::vector<Contour> contours;
        for (const Polygon& gap : difference(whole, parts)) {
            if (endless && geometry::signed_area(gap) > 0.0 && is_far_around(gap)) continue;
            contours.push_back(with_fillets(reversed(with_arcs(gap, discs)), options_.contour_fillet()));
        }
        return contours;
    }

    /// The patches that may reach into a region. Every patch holds a place on a bar's line, so a patch that
    /// reaches in meets the lines around the region.
    [[nodiscard]] std::vector<std::size_t> near(const Face& face) const {
        std::vector<std::size_t> found;
        add_near(found, face.outer);
        for (const Walk& island : face.islands) add_near(found, island);
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }
    void add_near(std::vector<std::size_t>& found, const Walk& walk) const {
        for (std::size_t i = 0; i < walk.size(); ++i) {
            const std::array<Point2, 2> line = {walk[i], walk[(i + 1) % walk.size()]};
            const auto meeting = grid_.meeting(geometry::box_of(line));
            found.insert(found.end(), meeting.begin(), meeting.end());
        }
    }

    [[nodiscard]] Polygon far_around() const {
        Box box = patches_.front().box;
        for (const Patch& patch : patches_) box = geometry::united(box, patch.box);
        box = grown(box, kMargin);
        return {{box.xmin, box.ymin}, {box.xmax, box.ymin}, {box.xmax, box.ymax}, {box.xmin, box.ymax}};
    }
    [[nodiscard]] bool is_far_around(const Polygon& gap) const {
        const Polygon around = far_around();
        const Box box = geometry::box_of(std::span<const Point2>(gap));
        return box.xmin < around[0].x + 0.5 * kMargin && box.xmax > around[2].x - 0.5 * kMargin;
    }
    void drill(Shape& shape) const {
        if (options_.bolt_diameter == 0.0) return;
        for (std::size_t i = 0; i < options_.bolts.size(); ++i) {
            const Point2 center = place(options_.bolts[i]);
            for (std::size_t j = 0; j < i; ++j) {
                if (distance(center, place(options_.bolts[j])) > options_.bolt_diameter) continue;
                throw base::InputError("the holes for bolts at nodes " + std::to_string(options_.bolts[j]) +
                                       " and " + std::to_string(options_.bolts[i]) + " meet, at " +
                                       place_text(center));
            }
            piece_around(shape, center).openings.push_back(reversed(circle(center, options_.hole_radius())));
        }
    }

    static constexpr double kMargin = 0.01;  // m
    const BarPlan& plan_;
    const ShapeOptions& options_;
    std::vector<Patch> patches_;
    geometry::BoxGrid grid_;
};

}  // namespace

void ShapeOptions::validate() const {
    require_length(fillet, "the radius of inner corners");
    require_length(kerf, "the kerf");
    require_length(frame_width, "the width of the frame");
    require_length(bolt_diameter, "the diameter of holes for bolts");
    require_length(eye_diameter, "the diameter of eyes");
    if (bolt_diameter > 0.0 && fabrication::eye_diameter(*this) <= bolt_diameter)
        throw base::InputError("the diameter of eyes is " + base::format_number(eye_diameter) +
                               " m, which is not above that of their holes, " +
                               base::format_number(bolt_diameter) + " m");
    if (bolt_diameter > 0.0 && bolt_diameter <= kerf)
        throw base::InputError("the diameter of holes for bolts is not above the kerf");
}

double ShapeOptions::eye_radius() const {
    return 0.5 * (fabrication::eye_diameter(*this) + kerf);
}

double ShapeOptions::contour_fillet() const {
    return std::max(0.0, fillet - 0.5 * kerf);
}

ShapeOptions ShapeOptions::without_kerf() const {
    ShapeOptions options = *this;
    options.kerf = 0.0;
    return options;
}

Shape make_shape(const simulation::Surface& surface, const ShapeOptions& options) {
    options.validate();
    return make_shape(bar_plan(surface, options.frame_width), options);
}

Shape make_shape(const BarPlan& plan, const ShapeOptions& options) {
    options.validate();
    require_below_surface(plan, options);
    require_wide_bars(plan);
    if (options.bolt_diameter > 0.0) require_bars_at_bolts(plan, options.bolts);
    return ShapeMaker(plan, options).run();
}

std::size_t opening_count(const Shape& shape) {
    std::size_t count = 0;
    for (const Piece& piece : shape.pieces) count += piece.openings.size();
    return count;
}

double area(const Shape& shape) {
    double sum = 0.0;
    for (const Piece& piece : shape.pieces) {
        sum += signed_area(piece.outer);
        for (const Contour& opening : piece.openings) sum += signed_area(opening);
    }
    return sum;
}

double cut_length(const Shape& shape) {
    double sum = 0.0;
    for (const Piece& piece : shape.pieces) {
        sum += length(piece.outer);
        for (const Contour& opening : piece.openings) sum += length(opening);
    }
    return sum;
}

Box box_of(const Shape& shape) {
    Box box = box_of(shape.pieces.front().outer);
    for (const Piece& piece : shape.pieces) box = united(box, box_of(piece.outer));
    return box;
}

}  // namespace fretwork::fabrication

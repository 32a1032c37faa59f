// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/results/section_stress.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fretwork::mechanics {
namespace {

using Eigen::Vector2d;
using std::numbers::pi;

/// Shear stresses of torsion in a solid rectangle |x| <= a, |y| <= b with a <= b, if twist times shear
/// modulus is one [Timoshenko1951, 109].
class RectangleTorsion {
  public:
    RectangleTorsion(double a, double b) : a_(a), b_(b) {}

    /// The shear stresses along x and y.
    [[nodiscard]] Vector2d at(double x, double y) const {
        constexpr int kTerms = 400;
        double along_x = 0.0;
        double along_y = 0.0;
        double sign = 1.0;  // (-1)^((n - 1) / 2)
        for (int n = 1; n < kTerms; n += 2, sign = -sign) {
            const double k = n * pi / (2.0 * a_);
            // cosh(k y) / cosh(k b) and sinh(k y) / cosh(k b) follow without large numbers.
            const double inner = std::exp(k * (std::abs(y) - b_));
            const double outer = 1.0 + std::exp(-2.0 * k * b_);
            const double decay = std::exp(-2.0 * k * std::abs(y));
            const double cosh_ratio = inner * (1.0 + decay) / outer;
            const double sinh_ratio = std::copysign(inner * (1.0 - decay) / outer, y);
            along_x -= sign / (n * n) * sinh_ratio * std::cos(k * x);
            along_y -= sign / (n * n) * cosh_ratio * std::sin(k * x);
        }
        const double scale = 16.0 * a_ / (pi * pi);
        return {scale * along_x, 2.0 * x + scale * along_y};
    }

  private:
    double a_;
    double b_;
};

}  // namespace

class SectionPoints::Builder {
  public:
    Builder(const Section& section, std::vector<Point>& points) : section_(section), points_(points) {}

    void operator()(const RectangleShape& shape) {
        constexpr int kSteps = 8;  // number of steps over half a side
        const Vector2d half(0.5 * shape.width, 0.5 * shape.height);
        const bool is_upright = half.x() <= half.y();
        const RectangleTorsion torsion(half.minCoeff(), half.maxCoeff());
        const auto add = [&](double share2, double share3) {
            const Vector2d place = half.cwiseProduct(Vector2d(share2, share3));
            const Vector2d twist =
                is_upright ? torsion.at(place[0], place[1]) : rotated_back(torsion.at(place[1], -place[0]));
            const double usual = 1.5 / section_.area;
            add_point(place, {usual * (1.0 - share2 * share2), 0.0}, {0.0, usual * (1.0 - share3 * share3)},
                      twist / section_.J);
        };
        add(0.0, 0.0);
        for (int i = -kSteps; i <= kSteps; ++i) {
            const double share = static_cast<double>(i) / kSteps;
            for (const double side : {-1.0, 1.0}) {
                add(share, side);
                if (std::abs(i) < kSteps) add(side, share);  // each corner once
            }
        }
    }

    void operator()(const CircleShape& shape) { add_ring(0.5 * shape.diameter, 4.0 / 3.0); }

    void operator()(const TubeShape& shape) {
        const double outer = 0.5 * shape.outer_diameter;
        const double inner = 0.5 * shape.inner_diameter;
        const double factor =
            4.0 / 3.0 * (outer * outer + outer * inner + inner * inner) / (outer * outer + inner * inner);
        add_ring(outer, factor);
        add_ring(inner, factor);
    }

    void operator()(const IShape& shape) {
        const double arm = 0.5 * (shape.height - shape.flange_thickness);
        const double junction = 0.5 * shape.height - shape.flange_thickness;
        const double flange = shape.width * shape.flange_thickness * arm;  // first moment of one flange
        const double web_at_middle = flange + 0.5 * shape.web_thickness * junction * junction;
        const double by_web = 1.0 / (section_.I2 * shape.web_thickness);
        const double usual2 = 1.5 / (2.0 * shape.width * shape.flange_thickness);  // the flanges bear V2
        for (const double turn : {-1.0, 1.0}) {  // the stress of torsion has both signs over a thickness
            const Vector2d in_flange(turn * shape.flange_thickness / section_.J, 0.0);
            const Vector2d in_web(0.0, turn * shape.web_thickness / section_.J);
            for (const double side : {-1.0, 1.0}) {
                const double x3 = 0.5 * side * shape.height;
                for (const double end : {-1.0, 1.0}) {
                    add_point({0.5 * end * shape.width, x3}, {0.0, 0.0}, {0.0, 0.0}, in_flange);
                    // The shear stress flows from half of a flange into the web.
                    add_point({0.0, x3}, {usual2, 0.0}, {0.5 * end * shape.width * arm / section_.I2, 0.0},
                              in_flange);
                    add_point({0.5 * end * shape.web_thickness, side * junction}, {0.0, 0.0},
                              {0.0, flange * by_web}, in_web);
                }
            }
            add_point({0.0, 0.0}, {0.0, 0.0}, {0.0, web_at_middle * by_web}, in_web);
        }
    }

  private:
    /// Convert a stress from axes x = 3 and y = -2 to axes 2 and 3.
    static Vector2d rotated_back(const Vector2d& stress) { return {-stress.y(), stress.x()}; }

    void add_point(const Vector2d& place, const Vector2d& by_v2, const Vector2d& by_v3,
                   const Vector2d& by_torsion) {
        Point point;
        point.normal << 1.0 / section_.area, place[1] / section_.I2, -place[0] / section_.I3;
        point.shear.col(0) = by_v2;
        point.shear.col(1) = by_v3;
        point.shear.col(2) = by_torsion;
        points_.push_back(point);
    }

    /// Add the points of a ring. The shear stress runs along the ring, and its largest value is `factor`
    /// times its mean.
    void add_ring(double radius, double factor) {
        constexpr int kPoints = 32;
        for (int i = 0; i < kPoints; ++i) {
            const double angle = 2.0 * pi * i / kPoints;
            const Vector2d outward(std::cos(angle), std::sin(angle));
            const Vector2d along(-outward.y(), outward.x());
            const double usual = factor / section_.area;
            add_point(radius * outward, usual * along[0] * along, usual * along[1] * along,
                      radius / section_.J * along);
        }
    }

    const Section& section_;
    std::vector<Point>& points_;
};

SectionPoints::SectionPoints(const Section& section) {
    std::visit(Builder(section, points_), shape_of(section));
}

SectionStress SectionPoints::largest(const SectionForces& forces) const {
    const Eigen::Vector3d normal_forces(forces.N, forces.M2, forces.M3);
    const Eigen::Vector3d shear_forces(forces.V2, forces.V3, forces.T);
    SectionStress largest;
    for (const Point& point : points_) {
        const double normal = point.normal.dot(normal_forces);
        const double shear_squared = (point.shear * shear_forces).squaredNorm();
        largest.normal = std::max(largest.normal, std::abs(normal));
        largest.shear = std::max(largest.shear, std::sqrt(shear_squared));
        largest.von_mises = std::max(largest.von_mises, std::sqrt(normal * normal + 3.0 * shear_squared));
    }
    return largest;
}

SectionPoints::PowerSum SectionPoints::power_sum(const SectionForces& forces, const Power& power) const {
    const Eigen::Vector3d normal_forces(forces.N, forces.M2, forces.M3);
    const Eigen::Vector3d shear_forces(forces.V2, forces.V3, forces.T);
    PowerSum sum;
    Eigen::Vector3d by_normal = Eigen::Vector3d::Zero();
    Eigen::Vector3d by_shear = Eigen::Vector3d::Zero();
    for (const Point& point : points_) {
        const double normal = point.normal.dot(normal_forces);
        const Eigen::Vector2d shear = point.shear * shear_forces;
        const double square = normal * normal + 3.0 * shear.squaredNorm();
        if (square == 0.0) continue;
        const double term = std::pow(square / (power.reference * power.reference), 0.5 * power.exponent);
        const double slope = power.exponent * term / square;
        sum.value += term;
        by_normal += slope * normal * point.normal.transpose();
        by_shear += 3.0 * slope * point.shear.transpose() * shear;
    }
    sum.gradient << by_normal[0], by_shear[0], by_shear[1], by_shear[2], by_normal[1], by_normal[2];
    return sum;
}

}  // namespace fretwork::mechanics

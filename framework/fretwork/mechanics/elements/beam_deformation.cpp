// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/elements/beam_deformation.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace fretwork::mechanics::elements {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The series F = sum over n of 2^n (n!)^2 / (2n + 1)! x^n with x = 1 - c. Below kSeriesReach, this number of
/// terms is exact to rounding.
constexpr double kSeriesReach = 0.05;
constexpr std::array<double, 12> kRatioSeries = [] {
    std::array<double, 12> series{1.0};
    for (std::size_t n = 1; n < series.size(); ++n)
        series[n] = series[n - 1] * static_cast<double>(n) / (2.0 * static_cast<double>(n) + 1.0);
    return series;
}();

AngleRatio angle_ratio(double c) {
    const double x = 1.0 - c;
    if (x < kSeriesReach) {
        AngleRatio ratio{0.0, 0.0, 0.0};
        for (std::size_t n = kRatioSeries.size(); n-- > 0;) {
            ratio.curvature = ratio.curvature * x + 2.0 * ratio.slope;
            ratio.slope = ratio.slope * x + ratio.value;
            ratio.value = ratio.value * x + kRatioSeries[n];
        }
        ratio.slope = -ratio.slope;
        return ratio;
    }
    // The bound avoids a division by zero if an end points against the chord.
    const double cosine = std::max(c, -1.0 + 1e-12);
    const double square = 1.0 - cosine * cosine;
    const double value = std::acos(cosine) / std::sqrt(square);
    const double slope = (cosine * value - 1.0) / square;
    return {value, slope, (value + 3.0 * cosine * slope) / square};
}

EndView view_from(const Matrix3d& axes, const Vector3d& direction) {
    const double c = axes.col(0).dot(direction);
    return {c, axes.col(1).dot(direction), axes.col(2).dot(direction), angle_ratio(c)};
}

/// The second derivative of e . a with respect to a spin that turns a: (e a^T + a e^T) / 2 - (e . a) I.
Matrix3d spin_curvature(const Vector3d& e, const Vector3d& a) {
    Matrix3d m = 0.5 * e * a.transpose();
    m += m.transpose().eval();
    m.diagonal().array() -= e.dot(a);
    return m;
}

/// Add the second derivative of a . b, where a turns with the first end and b with the second.
void add_product_curvature(const Vector3d& a, const Vector3d& b, MotionMatrix& m) {
    const Matrix3d own = spin_curvature(a, b);
    m.block<3, 3>(kSpin1, kSpin1) += own;
    m.block<3, 3>(kSpin2, kSpin2) += own;
    Matrix3d mixed = -b * a.transpose();
    mixed.diagonal().array() += a.dot(b);
    m.block<3, 3>(kSpin1, kSpin2) += mixed;
    m.block<3, 3>(kSpin2, kSpin1) += mixed.transpose();
}

}  // namespace

BeamDeformation::BeamDeformation(const Matrix3d& axes, double length, std::span<const NodeState> ends)
    : axes1_(ends[0].rotation.toRotationMatrix() * axes), axes2_(ends[1].rotation.toRotationMatrix() * axes) {
    const Vector3d moved = ends[1].displacement - ends[0].displacement;
    const Vector3d rest = length * axes.col(0);
    const Vector3d chord = rest + moved;
    length_ = chord.norm();
    direction_ = chord / length_;
    end1_ = view_from(axes1_, direction_);
    end2_ = view_from(axes2_, direction_);
    sine_ = 0.5 * (axes2_.col(1).dot(axes1_.col(2)) - axes2_.col(2).dot(axes1_.col(1)));
    cosine_ = 0.5 * (axes2_.col(1).dot(axes1_.col(1)) + axes2_.col(2).dot(axes1_.col(2)));
    // This form avoids the difference of two nearly equal lengths.
    elongation_ = moved.dot(2.0 * rest + moved) / (length_ + length);
}

BeamVector BeamDeformation::values() const {
    BeamVector d;
    d[kElongation] = elongation_;
    d[kBow2] = 0.5 * (end1_.bend2() - end2_.bend2());
    d[kSway2] = 0.5 * (end1_.bend2() + end2_.bend2());
    d[kBow3] = 0.5 * (end1_.bend3() - end2_.bend3());
    d[kSway3] = 0.5 * (end1_.bend3() + end2_.bend3());
    d[kTwist] = std::atan2(sine_, cosine_);
    return d;
}

DeformationSlopes BeamDeformation::slopes() const {
    DeformationSlopes s = DeformationSlopes::Zero();
    s.block<1, 3>(kElongation, kChord) = direction_.transpose();
    add_end_slopes(end1_, axes1_, {kSpin1, 0.5}, s);
    add_end_slopes(end2_, axes2_, {kSpin2, -0.5}, s);
    const Vector3d turn = twist_slope();
    s.block<1, 3>(kTwist, kSpin1) = turn.transpose();
    s.block<1, 3>(kTwist, kSpin2) = -turn.transpose();
    return s;
}

MotionMatrix BeamDeformation::curvature(const BeamVector& stress) const {
    MotionMatrix m = MotionMatrix::Zero();
    m.block<3, 3>(kChord, kChord) = stress[kElongation] * chord_projection();
    const double bow2 = 0.5 * stress[kBow2];
    const double bow3 = 0.5 * stress[kBow3];
    const double sway2 = 0.5 * stress[kSway2];
    const double sway3 = 0.5 * stress[kSway3];
    add_end_curvature(end1_, axes1_, {kSpin1, sway2 + bow2, sway3 + bow3}, m);
    add_end_curvature(end2_, axes2_, {kSpin2, sway2 - bow2, sway3 - bow3}, m);
    add_twist_curvature(stress[kTwist], m);
    return m;
}

/// The derivative (I - e e^T) / l of the chord's direction e with respect to the chord.
Matrix3d BeamDeformation::chord_projection() const {
    return (Matrix3d::Identity() - direction_ * direction_.transpose()) / length_;
}

void BeamDeformation::add_end_slopes(const EndView& end, const Matrix3d& axes, BowShare share,
                                     DeformationSlopes& s) const {
    const auto& [value, slope, curvature] = end.ratio;
    // The first derivatives are those of e . b, with a vector b that turns with the section.
    const Vector3d b2 = value * axes.col(2) + slope * end.p3 * axes.col(0);
    const Vector3d b3 = -value * axes.col(1) - slope * end.p2 * axes.col(0);
    const auto add = [&](int bow, int sway, const Vector3d& b) {
        const Eigen::RowVector3d by_chord = ((b - b.dot(direction_) * direction_) / length_).transpose();
        const Eigen::RowVector3d by_spin = b.cross(direction_).transpose();
        s.block<1, 3>(sway, kChord) += 0.5 * by_chord;
        s.block<1, 3>(bow, kChord) += share.bow * by_chord;
        s.block<1, 3>(sway, share.spin) = 0.5 * by_spin;
        s.block<1, 3>(bow, share.spin) = share.bow * by_spin;
    };
    add(kBow2, kSway2, b2);
    add(kBow3, kSway3, b3);
}

void BeamDeformation::add_end_curvature(const EndView& end, const Matrix3d& axes, EndStress stress,
                                        MotionMatrix& m) const {
    const auto& [value, slope, curvature] = end.ratio;
    const double across = stress.bend2 * end.p3 - stress.bend3 * end.p2;
    const Vector3d bent = stress.bend2 * axes.col(2) - stress.bend3 * axes.col(1);
    add_dot_curvature(value * bent + slope * across * axes.col(0), stress.spin, m);
    const Eigen::Matrix<double, 6, 1> by_axis = dot_slope(axes.col(0));
    const Eigen::Matrix<double, 6, 1> by_bent = slope * dot_slope(bent) + 0.5 * curvature * across * by_axis;
    Eigen::Matrix<double, 6, 6> outer = by_axis * by_bent.transpose();
    outer += outer.transpose().eval();
    m.block<3, 3>(kChord, kChord) += outer.topLeftCorner<3, 3>();
    m.block<3, 3>(kChord, stress.spin) += outer.topRightCorner<3, 3>();
    m.block<3, 3>(stress.spin, kChord) += outer.bottomLeftCorner<3, 3>();
    m.block<3, 3>(stress.spin, stress.spin) += outer.bottomRightCorner<3, 3>();
}

/// The derivative of e . b with respect to chord and spin, where b turns with a section.
Eigen::Matrix<double, 6, 1> BeamDeformation::dot_slope(const Vector3d& b) const {
    Eigen::Matrix<double, 6, 1> slope;
    slope.head<3>() = (b - b.dot(direction_) * direction_) / length_;
    slope.tail<3>() = b.cross(direction_);
    return slope;
}

/// Add the second derivative of e . b, where b turns with the section of `spin`.
void BeamDeformation::add_dot_curvature(const Vector3d& b, int spin, MotionMatrix& m) const {
    const double along = b.dot(direction_);
    const Vector3d across = b - along * direction_;
    Matrix3d by_chord = across * direction_.transpose();
    by_chord += by_chord.transpose().eval();
    m.block<3, 3>(kChord, kChord) -= by_chord / (length_ * length_) + along / length_ * chord_projection();
    const Matrix3d mixed = geometry::cross_matrix(b) * chord_projection();
    m.block<3, 3>(spin, kChord) += mixed;
    m.block<3, 3>(kChord, spin) += mixed.transpose();
    m.block<3, 3>(spin, spin) += spin_curvature(direction_, b);
}

/// The derivative of sine_ with respect to the first end's spin. The derivative with respect to the second
/// end's spin is opposite. The same holds for cosine_.
Vector3d BeamDeformation::sine_slope() const {
    return 0.5 * (axes1_.col(2).cross(axes2_.col(1)) - axes1_.col(1).cross(axes2_.col(2)));
}
Vector3d BeamDeformation::cosine_slope() const {
    return 0.5 * (axes1_.col(1).cross(axes2_.col(1)) + axes1_.col(2).cross(axes2_.col(2)));
}
Vector3d BeamDeformation::twist_slope() const {
    return (cosine_ * sine_slope() - sine_ * cosine_slope()) / (sine_ * sine_ + cosine_ * cosine_);
}

void BeamDeformation::add_twist_curvature(double stress, MotionMatrix& m) const {
    const double square = sine_ * sine_ + cosine_ * cosine_;
    const double by_sine = stress * cosine_ / square;
    const double by_cosine = -stress * sine_ / square;
    // by_sine * sine + by_cosine * cosine, as the sum of two products a . b of vectors of the two ends
    add_product_curvature(0.5 * (by_sine * axes1_.col(2) + by_cosine * axes1_.col(1)), axes2_.col(1), m);
    add_product_curvature(0.5 * (by_cosine * axes1_.col(2) - by_sine * axes1_.col(1)), axes2_.col(2), m);
    const Vector3d s = sine_slope();
    const Vector3d c = cosine_slope();
    const double mixed = stress / (square * square);
    Matrix3d outer = mixed * ((sine_ * sine_ - cosine_ * cosine_) * s * c.transpose() -
                              sine_ * cosine_ * (s * s.transpose() - c * c.transpose()));
    outer += outer.transpose().eval();
    m.block<3, 3>(kSpin1, kSpin1) += outer;
    m.block<3, 3>(kSpin2, kSpin2) += outer;
    m.block<3, 3>(kSpin1, kSpin2) -= outer;
    m.block<3, 3>(kSpin2, kSpin1) -= outer;
}

}  // namespace fretwork::mechanics::elements

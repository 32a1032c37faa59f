// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/detail/beam_element.hpp>
#include <fretwork/mechanics/detail/rotation.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace fretwork::mechanics::detail {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// What the deformations depend on: the chord's vector, and the spins of the two ends.
constexpr int kChord = 0;
constexpr int kSpin1 = 3;
constexpr int kSpin2 = 6;
constexpr int kMotions = 9;
using MotionVector = Eigen::Matrix<double, kMotions, 1>;
using MotionMatrix = Eigen::Matrix<double, kMotions, kMotions>;
using DeformationSlopes = Eigen::Matrix<double, kBeamDeformations, kMotions>;

/// F(c) = a / sin a with c = cos a: turns the sine components of a direction into those of its rotation
/// vector, equally about all axes. F' and F'' follow from its differential equation (1 - c^2) F' = c F - 1.
struct AngleRatio {
    double value;
    double slope;
    double curvature;
};

/// F = sum over n of 2^n (n!)^2 / (2n + 1)! x^n with x = 1 - c; so many terms are exact to rounding below
/// kSeriesReach.
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
    const double cosine = std::max(c, -1.0 + 1e-12);  // folded back onto itself: no direction is left
    const double square = 1.0 - cosine * cosine;
    const double value = std::acos(cosine) / std::sqrt(square);
    const double slope = (cosine * value - 1.0) / square;
    return {value, slope, (value + 3.0 * cosine * slope) / square};
}

/// The direction of the chord seen from an end section.
struct EndView {
    double c, p2, p3;  ///< components of the chord's direction along the section's axes
    AngleRatio ratio;
    [[nodiscard]] double bend2() const { return ratio.value * p3; }
    [[nodiscard]] double bend3() const { return -ratio.value * p2; }
};

EndView view_from(const Matrix3d& axes, const Vector3d& direction) {
    const double c = axes.col(0).dot(direction);
    return {c, axes.col(1).dot(direction), axes.col(2).dot(direction), angle_ratio(c)};
}

/// Symmetric product for the second derivative of e . a along a spin of a: (e a^T + a e^T) / 2 - (e . a) I.
Matrix3d spin_curvature(const Vector3d& e, const Vector3d& a) {
    Matrix3d m = 0.5 * e * a.transpose();
    m += m.transpose().eval();
    m.diagonal().array() -= e.dot(a);
    return m;
}

class Deformed {
  public:
    Deformed(const BeamElement::Geometry& geometry, std::span<const NodeState> states)
        : axes1_(states[0].rotation.toRotationMatrix() * geometry.axes),
          axes2_(states[1].rotation.toRotationMatrix() * geometry.axes) {
        const Vector3d moved = states[1].displacement - states[0].displacement;
        const Vector3d rest = geometry.length * geometry.axes.col(0);
        const Vector3d chord = rest + moved;
        length_ = chord.norm();
        direction_ = chord / length_;
        end1_ = view_from(axes1_, direction_);
        end2_ = view_from(axes2_, direction_);
        sine_ = 0.5 * (axes2_.col(1).dot(axes1_.col(2)) - axes2_.col(2).dot(axes1_.col(1)));
        cosine_ = 0.5 * (axes2_.col(1).dot(axes1_.col(1)) + axes2_.col(2).dot(axes1_.col(2)));
        // Without the difference of two nearly equal lengths.
        elongation_ = moved.dot(2.0 * rest + moved) / (length_ + geometry.length);
    }

    [[nodiscard]] BeamVector deformations() const {
        BeamVector d;
        d[kElongation] = elongation_;
        d[kBow2] = 0.5 * (end1_.bend2() - end2_.bend2());
        d[kSway2] = 0.5 * (end1_.bend2() + end2_.bend2());
        d[kBow3] = 0.5 * (end1_.bend3() - end2_.bend3());
        d[kSway3] = 0.5 * (end1_.bend3() + end2_.bend3());
        d[kTwist] = std::atan2(sine_, cosine_);
        return d;
    }

    [[nodiscard]] DeformationSlopes slopes() const {
        DeformationSlopes s = DeformationSlopes::Zero();
        s.block<1, 3>(kElongation, kChord) = direction_.transpose();
        add_end_slopes(end1_, axes1_, {kSpin1, 0.5}, s);
        add_end_slopes(end2_, axes2_, {kSpin2, -0.5}, s);
        const Vector3d turn = twist_slope();
        s.block<1, 3>(kTwist, kSpin1) = turn.transpose();
        s.block<1, 3>(kTwist, kSpin2) = -turn.transpose();
        return s;
    }

    /// Sum over the deformations of stress times second derivative.
    [[nodiscard]] MotionMatrix curvature(const BeamVector& stress) const {
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

  private:
    struct BowShare {
        int spin;    ///< kSpin1 or kSpin2
        double bow;  ///< share of this end's rotation in the bow
    };
    struct EndStress {
        int spin;
        double bend2, bend3;
    };

    /// (I - e e^T) / l: how the chord's direction follows the chord.
    [[nodiscard]] Matrix3d chord_projection() const {
        return (Matrix3d::Identity() - direction_ * direction_.transpose()) / length_;
    }

    void add_end_slopes(const EndView& end, const Matrix3d& axes, BowShare share,
                        DeformationSlopes& s) const {
        const auto& [value, slope, curvature] = end.ratio;
        // bend = e . b for a vector b of the section, as far as first derivatives go
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

    void add_end_curvature(const EndView& end, const Matrix3d& axes, EndStress stress,
                           MotionMatrix& m) const {
        const auto& [value, slope, curvature] = end.ratio;
        const double across = stress.bend2 * end.p3 - stress.bend3 * end.p2;
        const Vector3d bent = stress.bend2 * axes.col(2) - stress.bend3 * axes.col(1);
        add_dot_curvature(value * bent + slope * across * axes.col(0), stress.spin, m);
        const Eigen::Matrix<double, 6, 1> by_axis = dot_slope(axes.col(0));
        const Eigen::Matrix<double, 6, 1> by_bent =
            slope * dot_slope(bent) + 0.5 * curvature * across * by_axis;
        Eigen::Matrix<double, 6, 6> outer = by_axis * by_bent.transpose();
        outer += outer.transpose().eval();
        m.block<3, 3>(kChord, kChord) += outer.topLeftCorner<3, 3>();
        m.block<3, 3>(kChord, stress.spin) += outer.topRightCorner<3, 3>();
        m.block<3, 3>(stress.spin, kChord) += outer.bottomLeftCorner<3, 3>();
        m.block<3, 3>(stress.spin, stress.spin) += outer.bottomRightCorner<3, 3>();
    }

    /// The derivative of e . b, b turning with a section, by chord and spin.
    [[nodiscard]] Eigen::Matrix<double, 6, 1> dot_slope(const Vector3d& b) const {
        Eigen::Matrix<double, 6, 1> slope;
        slope.head<3>() = (b - b.dot(direction_) * direction_) / length_;
        slope.tail<3>() = b.cross(direction_);
        return slope;
    }

    /// The second derivative of e . b, b turning with the section of `spin`.
    void add_dot_curvature(const Vector3d& b, int spin, MotionMatrix& m) const {
        const double along = b.dot(direction_);
        const Vector3d across = b - along * direction_;
        Matrix3d by_chord = across * direction_.transpose();
        by_chord += by_chord.transpose().eval();
        m.block<3, 3>(kChord, kChord) -=
            by_chord / (length_ * length_) + along / length_ * chord_projection();
        const Matrix3d mixed = cross_matrix(b) * chord_projection();
        m.block<3, 3>(spin, kChord) += mixed;
        m.block<3, 3>(kChord, spin) += mixed.transpose();
        m.block<3, 3>(spin, spin) += spin_curvature(direction_, b);
    }

    /// The derivative of the sine and the cosine of the twist by the first end's spin; the second's are
    /// opposite.
    [[nodiscard]] Vector3d sine_slope() const {
        return 0.5 * (axes1_.col(2).cross(axes2_.col(1)) - axes1_.col(1).cross(axes2_.col(2)));
    }
    [[nodiscard]] Vector3d cosine_slope() const {
        return 0.5 * (axes1_.col(1).cross(axes2_.col(1)) + axes1_.col(2).cross(axes2_.col(2)));
    }
    [[nodiscard]] Vector3d twist_slope() const {
        return (cosine_ * sine_slope() - sine_ * cosine_slope()) / (sine_ * sine_ + cosine_ * cosine_);
    }

    void add_twist_curvature(double stress, MotionMatrix& m) const {
        const double square = sine_ * sine_ + cosine_ * cosine_;
        const double by_sine = stress * cosine_ / square;
        const double by_cosine = -stress * sine_ / square;
        // by_sine * sine + by_cosine * cosine as two products of a vector of each end
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

    /// The second derivative of a . b, a turning with the first end and b with the second.
    static void add_product_curvature(const Vector3d& a, const Vector3d& b, MotionMatrix& m) {
        const Matrix3d own = spin_curvature(a, b);
        m.block<3, 3>(kSpin1, kSpin1) += own;
        m.block<3, 3>(kSpin2, kSpin2) += own;
        Matrix3d mixed = -b * a.transpose();
        mixed.diagonal().array() += a.dot(b);
        m.block<3, 3>(kSpin1, kSpin2) += mixed;
        m.block<3, 3>(kSpin2, kSpin1) += mixed.transpose();
    }

    Matrix3d axes1_, axes2_;
    Vector3d direction_;
    double length_ = 0.0;
    double elongation_ = 0.0;
    EndView end1_{}, end2_{};
    double sine_ = 0.0, cosine_ = 1.0;
};

BeamEnergy::Stiffness stiffness_of(const Section& section, const Material& material) {
    const double shear = material.shear_modulus();
    return {.axial = material.young_modulus * section.area,
            .torsion = shear * section.J,
            .bending2 = material.young_modulus * section.I2,
            .bending3 = material.young_modulus * section.I3,
            .shear_flexibility2 = section.shear_area2 ? 1.0 / (shear * *section.shear_area2) : 0.0,
            .shear_flexibility3 = section.shear_area3 ? 1.0 / (shear * *section.shear_area3) : 0.0};
}

/// The chord's vector is the difference of the end displacements.
void expand_force(const MotionVector& motion, Eigen::VectorXd& force) {
    force.resize(2 * kDofsPerNode);
    force.segment<3>(0) = -motion.segment<3>(kChord);
    force.segment<3>(3) = motion.segment<3>(kSpin1);
    force.segment<3>(6) = motion.segment<3>(kChord);
    force.segment<3>(9) = motion.segment<3>(kSpin2);
}

/// The motions that small displacements and rotations of the two nodes are.
MotionVector motion_of(const Eigen::VectorXd& displacements) {
    MotionVector motion;
    motion.segment<3>(kChord) = displacements.segment<3>(6) - displacements.segment<3>(0);
    motion.segment<3>(kSpin1) = displacements.segment<3>(3);
    motion.segment<3>(kSpin2) = displacements.segment<3>(9);
    return motion;
}

void expand_tangent(const MotionMatrix& motion, Eigen::MatrixXd& tangent) {
    tangent.resize(2 * kDofsPerNode, 2 * kDofsPerNode);
    constexpr int kPlace[4] = {kChord, kSpin1, kChord, kSpin2};
    constexpr double kSign[4] = {-1.0, 1.0, 1.0, 1.0};
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j)
            tangent.block<3, 3>(3 * i, 3 * j) =
                kSign[i] * kSign[j] * motion.block<3, 3>(kPlace[i], kPlace[j]);
    }
}

}  // namespace

BeamElement::BeamElement(const Geometry& geometry, const Section& section, const Material& material)
    : geometry_(geometry),
      energy_(stiffness_of(section, material), geometry.length),
      line_mass_(material.density * section.area),
      line_inertia_(material.density * (section.I2 + section.I3)) {}

void BeamElement::rest_stiffness(Eigen::MatrixXd& stiffness) const {
    using Row = Eigen::Matrix<double, 2 * kDofsPerNode, 1>;
    const Vector3d axis1 = geometry_.axes.col(0);
    const Vector3d axis2 = geometry_.axes.col(1);
    const Vector3d axis3 = geometry_.axes.col(2);
    const Vector3d zero = Vector3d::Zero();
    const Vector3d slope2 = axis2 / geometry_.length;
    const Vector3d slope3 = axis3 / geometry_.length;
    Row rows[kBeamDeformations];
    rows[kElongation] << -axis1, zero, axis1, zero;
    rows[kBow2] << zero, 0.5 * axis2, zero, -0.5 * axis2;
    rows[kSway2] << -slope3, 0.5 * axis2, slope3, 0.5 * axis2;
    rows[kBow3] << zero, 0.5 * axis3, zero, -0.5 * axis3;
    rows[kSway3] << slope2, 0.5 * axis3, -slope2, 0.5 * axis3;
    rows[kTwist] << zero, -axis1, zero, axis1;
    stiffness.setZero(2 * kDofsPerNode, 2 * kDofsPerNode);
    for (int i = 0; i < kBeamDeformations; ++i) {
        const Row scaled = energy_.rest_hessian()[i] * rows[i];
        for (int column = 0; column < 2 * kDofsPerNode; ++column)
            stiffness.col(column) += rows[i][column] * scaled;
    }
}

void BeamElement::evaluate(std::span<const NodeState> states, Demand demand,
                           ElementResponse& response) const {
    const Deformed deformed(geometry_, states);
    const BeamVector d = deformed.deformations();
    const DeformationSlopes slopes = deformed.slopes();
    const BeamEnergy::State state = energy_.evaluate(d);
    response.energy = state.value;
    expand_force(slopes.transpose().lazyProduct(state.gradient), response.force);
    if (demand == Demand::Force) return;
    MotionMatrix tangent = deformed.curvature(state.gradient);
    // Lazy: Eigen's blocked product is slower on matrices as small as these.
    const DeformationSlopes scaled = energy_.hessian(d, state).lazyProduct(slopes);
    tangent += slopes.transpose().lazyProduct(scaled);
    expand_tangent(tangent, response.tangent);
}

void BeamElement::geometric_stiffness(const Eigen::VectorXd& displacements,
                                      Eigen::MatrixXd& stiffness) const {
    const std::array<NodeState, 2> at_rest{};
    const Deformed rest(geometry_, at_rest);
    const DeformationSlopes slopes = rest.slopes();
    BeamEnergy::State state = energy_.evaluate(BeamVector::Zero());
    state.stress = energy_.rest_hessian().cwiseProduct(slopes * motion_of(displacements));
    BeamMatrix hessian = energy_.hessian(BeamVector::Zero(), state);
    hessian.diagonal() -= energy_.rest_hessian();
    expand_tangent(rest.curvature(state.stress) + slopes.transpose() * hessian * slopes, stiffness);
}

void BeamElement::mass(Eigen::MatrixXd& mass) const {
    const double l = geometry_.length;
    Eigen::Matrix<double, 12, 12> m = Eigen::Matrix<double, 12, 12>::Zero();
    const auto add = [&m](int i, int j, double value) {
        m(i, j) += value;
        if (i != j) m(j, i) += value;
    };
    const double along = line_mass_ * l / 6.0;
    const double twist = line_inertia_ * l / 6.0;
    const double bend = line_mass_ * l / 420.0;
    for (const auto& [dof, value] : {std::pair{0, along}, std::pair{3, twist}}) {
        add(dof, dof, 2.0 * value);
        add(dof + 6, dof + 6, 2.0 * value);
        add(dof, dof + 6, value);
    }
    // Deflection along axis 2 turns about axis 3 with the same sign, along axis 3 about axis 2 with the
    // other.
    for (const auto& [w, r, sign] : {std::tuple{1, 5, 1.0}, std::tuple{2, 4, -1.0}}) {
        add(w, w, 156.0 * bend);
        add(w + 6, w + 6, 156.0 * bend);
        add(w, w + 6, 54.0 * bend);
        add(r, r, 4.0 * l * l * bend);
        add(r + 6, r + 6, 4.0 * l * l * bend);
        add(r, r + 6, -3.0 * l * l * bend);
        add(w, r, sign * 22.0 * l * bend);
        add(w + 6, r + 6, -sign * 22.0 * l * bend);
        add(w, r + 6, -sign * 13.0 * l * bend);
        add(w + 6, r, sign * 13.0 * l * bend);
    }
    mass.resize(12, 12);
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j)
            mass.block<3, 3>(3 * i, 3 * j) =
                geometry_.axes * m.block<3, 3>(3 * i, 3 * j) * geometry_.axes.transpose();
    }
}

}  // namespace fretwork::mechanics::detail

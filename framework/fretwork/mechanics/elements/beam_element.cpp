// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/elements/beam_deformation.hpp>
#include <fretwork/mechanics/elements/beam_element.hpp>

#include <array>
#include <tuple>
#include <utility>

namespace fretwork::mechanics::elements {
namespace {

using Eigen::Matrix3d;

/// The change of the chord's vector is the difference of the end displacements.
void expand_force(const MotionVector& motion, Eigen::VectorXd& force) {
    force.resize(2 * kDofsPerNode);
    force.segment<3>(0) = -motion.segment<3>(kChord);
    force.segment<3>(3) = motion.segment<3>(kSpin1);
    force.segment<3>(6) = motion.segment<3>(kChord);
    force.segment<3>(9) = motion.segment<3>(kSpin2);
}

/// Map columns of motions to columns of the nodes' small motions.
void expand_slopes(const DeformationSlopes& motion, std::span<double> slopes) {
    Eigen::Map<Eigen::Matrix<double, kBeamDeformations, 2 * kDofsPerNode>> out(slopes.data());
    out.middleCols<3>(0) = -motion.middleCols<3>(kChord);
    out.middleCols<3>(3) = motion.middleCols<3>(kSpin1);
    out.middleCols<3>(6) = motion.middleCols<3>(kChord);
    out.middleCols<3>(9) = motion.middleCols<3>(kSpin2);
}

/// The motions of small displacements and rotations of the two nodes.
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

BeamEnergy::Stiffness beam_stiffness(const Section& section, const Material& material) {
    const double shear = material.shear_modulus();
    return {.axial = material.young_modulus * section.area,
            .torsion = shear * section.J,
            .bending2 = material.young_modulus * section.I2,
            .bending3 = material.young_modulus * section.I3,
            .shear_flexibility2 = section.shear_area2 ? 1.0 / (shear * *section.shear_area2) : 0.0,
            .shear_flexibility3 = section.shear_area3 ? 1.0 / (shear * *section.shear_area3) : 0.0};
}

BeamElement::BeamElement(const Geometry& geometry, const Section& section, const Material& material)
    : geometry_(geometry),
      energy_(beam_stiffness(section, material), geometry.length),
      line_mass_(material.density * section.area),
      line_inertia_(material.density * (section.I2 + section.I3)) {}

/// The sum over the deformations of stiffness * row^T row, written in 3 x 3 blocks. A row has the slopes of a
/// deformation. If it has u for the displacements and r for the rotations of end 1, it has -u and r for end 2
/// in a sway, and -u and -r in all other deformations.
void BeamElement::rest_stiffness(Eigen::MatrixXd& stiffness) const {
    const BeamVector& k = energy_.stiffness();
    const double l = geometry_.length;
    const Matrix3d along1 = geometry_.axes.col(0) * geometry_.axes.col(0).transpose();
    const Matrix3d along2 = geometry_.axes.col(1) * geometry_.axes.col(1).transpose();
    const Matrix3d along3 = geometry_.axes.col(2) * geometry_.axes.col(2).transpose();
    const Matrix3d across = geometry_.axes.col(1) * geometry_.axes.col(2).transpose();
    const Matrix3d push = k[kElongation] * along1 + (k[kSway3] * along2 + k[kSway2] * along3) / (l * l);
    const Matrix3d tilt = (k[kSway3] * across - k[kSway2] * across.transpose()) / (2.0 * l);
    const Matrix3d sway = 0.25 * (k[kSway2] * along2 + k[kSway3] * along3);
    const Matrix3d bow = k[kTwist] * along1 + 0.25 * (k[kBow2] * along2 + k[kBow3] * along3);
    stiffness.resize(2 * kDofsPerNode, 2 * kDofsPerNode);
    stiffness.block<3, 3>(0, 0) = stiffness.block<3, 3>(6, 6) = push;
    stiffness.block<3, 3>(0, 6) = stiffness.block<3, 3>(6, 0) = -push;
    stiffness.block<3, 3>(0, 3) = stiffness.block<3, 3>(0, 9) = tilt;
    stiffness.block<3, 3>(6, 3) = stiffness.block<3, 3>(6, 9) = -tilt;
    stiffness.block<3, 3>(3, 0) = stiffness.block<3, 3>(9, 0) = tilt.transpose();
    stiffness.block<3, 3>(3, 6) = stiffness.block<3, 3>(9, 6) = -tilt.transpose();
    stiffness.block<3, 3>(3, 3) = stiffness.block<3, 3>(9, 9) = sway + bow;
    stiffness.block<3, 3>(3, 9) = stiffness.block<3, 3>(9, 3) = sway - bow;
}

void BeamElement::evaluate(std::span<const NodeState> states, Demand demand,
                           ElementResponse& response) const {
    const BeamDeformation deformation(geometry_.axes, geometry_.length, states);
    const BeamVector d = deformation.values();
    const DeformationSlopes slopes = deformation.slopes();
    const BeamEnergy::State state = energy_.evaluate(d);
    response.energy = state.value;
    expand_force(slopes.transpose().lazyProduct(state.gradient), response.force);
    if (demand == Demand::Force) return;
    MotionMatrix tangent = deformation.curvature(state.gradient);
    // A lazy product, because Eigen's blocked product is slower on such small matrices.
    const DeformationSlopes scaled = energy_.hessian(d, state, state.stress).lazyProduct(slopes);
    tangent += slopes.transpose().lazyProduct(scaled);
    expand_tangent(tangent, response.tangent);
}

void BeamElement::evaluate_mixed(std::span<const NodeState> states, Demand demand,
                                 const ElementStresses& stresses, MixedResponse& response) const {
    const BeamDeformation deformation(geometry_.axes, geometry_.length, states);
    const BeamVector d = deformation.values();
    const DeformationSlopes slopes = deformation.slopes();
    const BeamEnergy::State state = energy_.evaluate(d);
    const Eigen::Map<const BeamVector> given(stresses.given.data());
    const BeamVector given_gradient = state.strain_slopes.transpose().lazyProduct(given);
    Eigen::Map<BeamVector>(stresses.own.data()) = state.stress;
    response.energy = state.value;
    expand_force(slopes.transpose().lazyProduct(state.gradient), response.force);
    expand_force(slopes.transpose().lazyProduct(given_gradient), response.given_force);
    if (demand == Demand::Force) return;
    MotionMatrix tangent = deformation.curvature(given_gradient);
    const DeformationSlopes scaled = energy_.hessian(d, state, given).lazyProduct(slopes);
    tangent += slopes.transpose().lazyProduct(scaled);
    expand_tangent(tangent, response.tangent);
    expand_slopes(state.strain_slopes.lazyProduct(slopes), stresses.slopes);
}

void BeamElement::stresses_of(std::span<const double> strains, std::span<double> stresses) const {
    Eigen::Map<BeamVector>(stresses.data()) =
        energy_.stiffness().cwiseProduct(Eigen::Map<const BeamVector>(strains.data()));
}

double BeamElement::relative_turn(std::span<const NodeState> states) const {
    return BeamDeformation(geometry_.axes, geometry_.length, states).values()[kTwist];
}

void BeamElement::geometric_stiffness(const Eigen::VectorXd& displacements,
                                      Eigen::MatrixXd& stiffness) const {
    const std::array<NodeState, 2> at_rest{};
    const BeamDeformation rest(geometry_.axes, geometry_.length, at_rest);
    const DeformationSlopes slopes = rest.slopes();
    const BeamEnergy::State state = energy_.evaluate(BeamVector::Zero());
    const BeamVector stress = energy_.stiffness().cwiseProduct(slopes * motion_of(displacements));
    BeamMatrix hessian = energy_.hessian(BeamVector::Zero(), state, stress);
    hessian.diagonal() -= energy_.stiffness();
    expand_tangent(rest.curvature(stress) + slopes.transpose() * hessian * slopes, stiffness);
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
    // A deflection along axis 2 turns the section about axis 3 with the same sign, and a deflection along
    // axis 3 about axis 2 with the opposite sign.
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

}  // namespace fretwork::mechanics::elements

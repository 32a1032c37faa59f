// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/elements/beam_energy.hpp>

namespace fretwork::mechanics::elements {
namespace {

constexpr double kThird = 1.0 / 3.0;
constexpr double kTwelfth = 1.0 / 12.0;

/// The share of a twist between the ends that is not due to bending. Bending also changes the directions of
/// the end sections.
double twist_share(const BeamVector& d) {
    return 1.0 / (1.0 + d[kBow2] * d[kBow2] + d[kBow3] * d[kBow3]);
}

}  // namespace

BeamEnergy::BeamEnergy(const Stiffness& s, double length) {
    const double f2 = 12.0 * s.bending2 * s.shear_flexibility3 / (length * length);
    const double f3 = 12.0 * s.bending3 * s.shear_flexibility2 / (length * length);
    const double k2 = 1.0 / (1.0 + f2);
    const double k3 = 1.0 / (1.0 + f3);
    stiffness_[kElongation] = s.axial / length;
    stiffness_[kBow2] = 4.0 * s.bending2 / length;
    stiffness_[kSway2] = 12.0 * s.bending2 * k2 / length;
    stiffness_[kBow3] = 4.0 * s.bending3 / length;
    stiffness_[kSway3] = 12.0 * s.bending3 * k3 / length;
    stiffness_[kTwist] = s.torsion / length;
    bow_shortening_ = kThird * length;
    sway2_shortening_ = (0.2 - f2 * f2) * k2 * k2 * length;
    sway3_shortening_ = (0.2 - f3 * f3) * k3 * k3 * length;
    shear2_ = f2 * k2;
    shear3_ = f3 * k3;
    twist2_ = 2.0 * k2;
    twist3_ = 2.0 * k3;
}

BeamVector BeamEnergy::strains(const BeamVector& d) const {
    BeamVector e = d;
    e[kElongation] +=
        0.5 * (bow_shortening_ * (d[kBow2] * d[kBow2] + d[kBow3] * d[kBow3]) +
               sway2_shortening_ * d[kSway2] * d[kSway2] + sway3_shortening_ * d[kSway3] * d[kSway3]);
    const double square = kTwelfth * d[kTwist] * d[kTwist];
    const double g2 = shear2_ * d[kSway2];
    const double g3 = shear3_ * d[kSway3];
    const double across = g3 * d[kBow2] - g2 * d[kBow3];  // cross product of the bow and the shear angle
    e[kBow2] += square * d[kBow2] + (kThird * across + 0.5 * d[kTwist]) * g3;
    e[kBow3] += square * d[kBow3] - (kThird * across + 0.5 * d[kTwist]) * g2;
    e[kSway2] += kThird * d[kTwist] * d[kBow3];
    e[kSway3] -= kThird * d[kTwist] * d[kBow2];
    e[kTwist] *= twist_share(d);
    e[kTwist] += twist3_ * d[kBow2] * d[kSway3] - twist2_ * d[kBow3] * d[kSway2];
    return e;
}

/// Row i holds the derivatives of strain i.
BeamMatrix BeamEnergy::strain_slopes(const BeamVector& d) const {
    BeamMatrix s = BeamMatrix::Identity();
    s(kElongation, kBow2) = bow_shortening_ * d[kBow2];
    s(kElongation, kBow3) = bow_shortening_ * d[kBow3];
    s(kElongation, kSway2) = sway2_shortening_ * d[kSway2];
    s(kElongation, kSway3) = sway3_shortening_ * d[kSway3];
    const double square = kTwelfth * d[kTwist] * d[kTwist];
    const double share = twist_share(d);
    const double loss = -2.0 * d[kTwist] * share * share;
    const double g2 = shear2_ * d[kSway2];
    const double g3 = shear3_ * d[kSway3];
    const double across = g3 * d[kBow2] - g2 * d[kBow3];
    const double turn = kThird * across + 0.5 * d[kTwist];
    s(kBow2, kBow2) = 1.0 + square + kThird * g3 * g3;
    s(kBow3, kBow3) = 1.0 + square + kThird * g2 * g2;
    s(kBow2, kBow3) = s(kBow3, kBow2) = -kThird * g2 * g3;
    s(kBow2, kTwist) = 2.0 * kTwelfth * d[kTwist] * d[kBow2] + 0.5 * g3;
    s(kBow2, kSway2) = -kThird * shear2_ * d[kBow3] * g3;
    s(kBow2, kSway3) = shear3_ * (turn + kThird * d[kBow2] * g3);
    s(kBow3, kTwist) = 2.0 * kTwelfth * d[kTwist] * d[kBow3] - 0.5 * g2;
    s(kBow3, kSway2) = -shear2_ * (turn - kThird * d[kBow3] * g2);
    s(kBow3, kSway3) = -kThird * shear3_ * d[kBow2] * g2;
    s(kSway2, kTwist) = kThird * d[kBow3];
    s(kSway2, kBow3) = kThird * d[kTwist];
    s(kSway3, kTwist) = -kThird * d[kBow2];
    s(kSway3, kBow2) = -kThird * d[kTwist];
    s(kTwist, kTwist) = share;
    s(kTwist, kBow2) = loss * d[kBow2] + twist3_ * d[kSway3];
    s(kTwist, kSway3) = twist3_ * d[kBow2];
    s(kTwist, kBow3) = loss * d[kBow3] - twist2_ * d[kSway2];
    s(kTwist, kSway2) = -twist2_ * d[kBow3];
    return s;
}

BeamEnergy::State BeamEnergy::evaluate(const BeamVector& d) const {
    State state;
    const BeamVector e = strains(d);
    state.stress = stiffness_.cwiseProduct(e);
    state.value = 0.5 * e.dot(state.stress);
    state.strain_slopes = strain_slopes(d);
    state.gradient.noalias() = state.strain_slopes.transpose().lazyProduct(state.stress);
    return state;
}

/// Add the second derivatives of the terms twist^2 bow / 12 and twist / (1 + bow^2) of the strains, times the
/// stresses.
void BeamEnergy::add_helix_terms(const BeamVector& d, const BeamVector& stress, BeamMatrix& h) {
    const double share = twist_share(d);
    const double loss = -2.0 * stress[kTwist] * share * share;
    const Eigen::Vector2d bow(d[kBow2], d[kBow3]);
    const Eigen::Vector2d bow_stress(stress[kBow2], stress[kBow3]);
    const Eigen::Vector2d mixed = 2.0 * kTwelfth * d[kTwist] * bow_stress + loss * bow;
    constexpr int kBow[2] = {kBow2, kBow3};
    for (int i = 0; i < 2; ++i) {
        h(kBow[i], kTwist) += mixed[i];
        h(kTwist, kBow[i]) += mixed[i];
        h(kBow[i], kBow[i]) += loss * d[kTwist];
        for (int j = 0; j < 2; ++j) h(kBow[i], kBow[j]) -= 4.0 * loss * d[kTwist] * share * bow[i] * bow[j];
    }
    h(kTwist, kTwist) += 2.0 * kTwelfth * bow.dot(bow_stress);
}

/// Add the second derivatives of the terms with two shear angles: (stress2 g3 - stress3 g2) (g3 bow2 - g2
/// bow3) / 3.
void BeamEnergy::add_shear_terms(const BeamVector& d, const BeamVector& stress, BeamMatrix& h) const {
    if (shear2_ == 0.0 && shear3_ == 0.0) return;
    const double g2 = shear2_ * d[kSway2];
    const double g3 = shear3_ * d[kSway3];
    BeamVector stress_slope = BeamVector::Zero();  // slope of stress2 g3 - stress3 g2
    stress_slope[kSway2] = -stress[kBow3] * shear2_;
    stress_slope[kSway3] = stress[kBow2] * shear3_;
    BeamVector across_slope = BeamVector::Zero();
    across_slope[kBow2] = g3;
    across_slope[kBow3] = -g2;
    across_slope[kSway2] = -shear2_ * d[kBow3];
    across_slope[kSway3] = shear3_ * d[kBow2];
    h += kThird * (stress_slope * across_slope.transpose() + across_slope * stress_slope.transpose());
    const double stress_across = stress[kBow2] * g3 - stress[kBow3] * g2;
    h(kBow2, kSway3) += kThird * stress_across * shear3_;
    h(kSway3, kBow2) += kThird * stress_across * shear3_;
    h(kBow3, kSway2) -= kThird * stress_across * shear2_;
    h(kSway2, kBow3) -= kThird * stress_across * shear2_;
}

BeamMatrix BeamEnergy::hessian(const BeamVector& d, const State& state, const BeamVector& stress) const {
    const BeamMatrix scaled = stiffness_.asDiagonal() * state.strain_slopes;
    BeamMatrix h = state.strain_slopes.transpose().lazyProduct(scaled);
    h(kBow2, kBow2) += stress[kElongation] * bow_shortening_;
    h(kBow3, kBow3) += stress[kElongation] * bow_shortening_;
    h(kSway2, kSway2) += stress[kElongation] * sway2_shortening_;
    h(kSway3, kSway3) += stress[kElongation] * sway3_shortening_;
    const auto add_product = [&h](int i, int j, double coefficient) {
        h(i, j) += coefficient;
        h(j, i) += coefficient;
    };
    add_helix_terms(d, stress, h);
    add_shear_terms(d, stress, h);
    add_product(kTwist, kSway3, 0.5 * stress[kBow2] * shear3_);
    add_product(kTwist, kSway2, -0.5 * stress[kBow3] * shear2_);
    add_product(kTwist, kBow3, stress[kSway2] * kThird);
    add_product(kTwist, kBow2, -stress[kSway3] * kThird);
    add_product(kBow2, kSway3, stress[kTwist] * twist3_);
    add_product(kBow3, kSway2, -stress[kTwist] * twist2_);
    return h;
}

}  // namespace fretwork::mechanics::elements

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/element.hpp>
#include <fretwork/mechanics/elements/beam_energy.hpp>

#include <array>

namespace fretwork::mechanics::elements {

BeamEnergy::Stiffness beam_stiffness(const Section& section, const Material& material);

/// A straight beam between two nodes that may move and turn by any amount.
///
/// The energy is a function of deformations that do not change in a rigid motion (BeamEnergy). They are
/// measured relative to the chord, in the end sections' own axes, so the axes of a round section can be
/// chosen freely. The linearization at rest is the linear Euler-Bernoulli element or, with shear areas,
/// Timoshenko's element.
class BeamElement final : public Element {
  public:
    struct Geometry {
        std::array<NodeIndex, 2> nodes;
        double length = 0.0;                                 ///< m
        Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< local axes 1, 2, 3 at rest, as columns
    };
    BeamElement(const Geometry& geometry, const Section& section, const Material& material);

    [[nodiscard]] std::span<const NodeIndex> nodes() const override { return geometry_.nodes; }
    void rest_stiffness(Eigen::MatrixXd& stiffness) const override;
    void evaluate(std::span<const NodeState> states, Demand demand, ElementResponse& response) const override;
    [[nodiscard]] Eigen::Index stress_count() const override { return kBeamDeformations; }
    void evaluate_mixed(std::span<const NodeState> states, Demand demand, const ElementStresses& stresses,
                        MixedResponse& response) const override;
    void stresses_of(std::span<const double> strains, std::span<double> stresses) const override;
    [[nodiscard]] double relative_turn(std::span<const NodeState> states) const override;
    void geometric_stiffness(const Eigen::VectorXd& displacements, Eigen::MatrixXd& stiffness) const override;
    void mass(Eigen::MatrixXd& mass) const override;

    [[nodiscard]] const Geometry& geometry() const { return geometry_; }

  private:
    Geometry geometry_;
    BeamEnergy energy_;
    double line_mass_;     ///< mass per length, kg/m
    double line_inertia_;  ///< moment of inertia about the axis per length, kg m
};

}  // namespace fretwork::mechanics::elements

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/elements/beam_element.hpp>

#include <memory>
#include <vector>

namespace fretwork::mechanics::elements {

/// A beam with hinges. A hinged end has an extra node. The motion of this node is the motion of the beam's
/// end relative to the frame's node, in the beam's axes at rest, turned with the frame's node. Supports fix
/// the components of the extra node that are not released.
class HingedElement final : public Element {
  public:
    /// @param hinges  the extra node of each end; an invalid index for an end without a hinge
    HingedElement(std::unique_ptr<const BeamElement> beam, const std::array<NodeIndex, 2>& hinges);

    [[nodiscard]] std::span<const NodeIndex> nodes() const override { return nodes_; }
    void rest_stiffness(Eigen::MatrixXd& stiffness) const override;
    void evaluate(std::span<const NodeState> states, Demand demand, ElementResponse& response) const override;
    [[nodiscard]] Eigen::Index stress_count() const override { return beam_->stress_count(); }
    void evaluate_mixed(std::span<const NodeState> states, Demand demand, const ElementStresses& stresses,
                        MixedResponse& response) const override;
    void stresses_of(std::span<const double> strains, std::span<double> stresses) const override {
        beam_->stresses_of(strains, stresses);
    }
    [[nodiscard]] double relative_turn(std::span<const NodeState> states) const override;
    void geometric_stiffness(const Eigen::VectorXd& displacements, Eigen::MatrixXd& stiffness) const override;
    void mass(Eigen::MatrixXd& mass) const override;

  private:
    struct Hinge {
        Eigen::Index end;   ///< 0 or 1
        Eigen::Index slot;  ///< index in nodes_
    };
    /// The state of a hinged end of the beam, and the quantities that its derivatives need.
    struct HingedEnd {
        Eigen::Matrix3d turned_axes;  ///< the beam's axes, turned with the frame's node
        Eigen::Vector3d arm;          ///< vector from the frame's node to the beam's end
        NodeState state;
    };
    static HingedEnd compose(const Eigen::Matrix3d& axes, const NodeState& node, const NodeState& hinge);
    /// The states of the beam's ends for given states of the nodes, and the map from small motions of the
    /// nodes to small motions of the ends.
    struct Hung {
        std::array<NodeState, 2> ends;
        std::array<HingedEnd, 2> hinged;
        Eigen::MatrixXd map;
    };
    [[nodiscard]] Hung hang(std::span<const NodeState> states) const;
    [[nodiscard]] Eigen::MatrixXd rest_map() const;
    /// Add the contribution of the forces on the beam's ends to the tangent. The states of the ends depend
    /// nonlinearly on the states of the nodes.
    void add_hinge_curvature(const Eigen::VectorXd& force, const std::array<HingedEnd, 2>& hinged,
                             Eigen::MatrixXd& tangent) const;
    [[nodiscard]] Eigen::Index size() const {
        return static_cast<Eigen::Index>(nodes_.size()) * kDofsPerNode;
    }

    std::unique_ptr<const BeamElement> beam_;
    std::vector<NodeIndex> nodes_;
    std::vector<Hinge> hinges_;
};

}  // namespace fretwork::mechanics::elements

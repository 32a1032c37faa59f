// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/condensation.hpp>
#include <fretwork/mechanics/corotational_element.hpp>
#include <fretwork/mechanics/node_states.hpp>
#include <fretwork/reduction/detail/rigid_motions.hpp>
#include <fretwork/reduction/models/condensed_tile.hpp>
#include <fretwork/reduction/models/corotational_tile.hpp>
#include <fretwork/reduction/response.hpp>

#include <utility>
#include <vector>

namespace fretwork::reduction {
namespace {

using mechanics::CorotationalMotion;
using mechanics::kDofsPerNode;
using mechanics::NodeValues;

/// A tile with a linear stiffness in corotating axes. This class does not know the tile's beams.
class BodyTile : public TileStructure {
  public:
    explicit BodyTile(mechanics::CorotationalBody::Parts parts)
        : body_(std::make_shared<mechanics::CorotationalBody>(std::move(parts))) {}

    [[nodiscard]] std::span<const Eigen::Vector3d> inner_nodes() const override { return {}; }

    void add_to(StructureParts& surface, const TilePlace& place) const override {
        surface.elements.push_back(
            mechanics::corotational_element({place.nodes.begin(), place.nodes.end()}, body_, place.turn));
    }

    [[nodiscard]] std::optional<BeamMotion> beam_motion(const TileMotion& /*motion*/) const override {
        return std::nullopt;
    }

    [[nodiscard]] const mechanics::CorotationalBody* corotational_body() const override {
        return body_.get();
    }

  protected:
    [[nodiscard]] const std::shared_ptr<const mechanics::CorotationalBody>& body() const { return body_; }

  private:
    std::shared_ptr<const mechanics::CorotationalBody> body_;
};

/// A tile whose stiffness is the condensed stiffness of its beams.
class CorotationalTile final : public BodyTile {
  public:
    CorotationalTile(mechanics::CorotationalBody::Parts parts, std::shared_ptr<const InnerNodes> inner)
        : BodyTile(std::move(parts)), mean_(Eigen::Vector3d::Zero()), inner_(std::move(inner)) {
        const auto& nodes = inner_->tile().nodes;
        for (int i = 0; i < inner_->interface_nodes(); ++i) mean_ += nodes[i] / inner_->interface_nodes();
    }

    /// The inner nodes follow the interface nodes in the corotating axes, and move with these axes.
    [[nodiscard]] std::optional<BeamMotion> beam_motion(const TileMotion& motion) const override {
        if (motion.displacements == Displacements::Small) return condensed_motion(*inner_, motion);
        const auto moved =
            mechanics::corotational_motion(*body(), motion.turn, mechanics::node_states(motion.nodes));
        if (!moved) return std::nullopt;
        const NodeValues followed = inner_->follow(moved->in_axes);
        const Eigen::Index own = motion.nodes.rows();
        BeamMotion beams{NodeValues(own + followed.rows(), kDofsPerNode),
                         NodeValues(own + followed.rows(), kDofsPerNode)};
        beams.nodes << motion.nodes, carried(followed, *moved, motion.turn);
        beams.in_axes << turned(moved->in_axes, motion.turn), turned(followed, motion.turn);
        return beams;
    }

    [[nodiscard]] std::optional<NodeValues> motion_gradient(const TileMotion& motion,
                                                            const NodeValues& by_beams) const override {
        const NodeValues by_strains = condensed_gradient(*inner_, motion.turn, by_beams);
        if (motion.displacements == Displacements::Small) return turned(by_strains, motion.turn);
        NodeValues gradient(by_strains.rows(), kDofsPerNode);
        gradient.reshaped<Eigen::RowMajor>().noalias() =
            strain_slopes(motion).transpose() * by_strains.reshaped<Eigen::RowMajor>();
        for (Eigen::Index i = 0; i < gradient.rows(); ++i) {
            const Eigen::Matrix3d spins = geometry::spin_map(motion.nodes.row(i).tail<3>().transpose());
            gradient.row(i).tail<3>() = (gradient.row(i).tail<3>() * spins).eval();
        }
        return gradient;
    }

  private:
    /// The derivatives of the interface nodes' displacements in the corotating axes, with respect to motions
    /// of the interface nodes.
    [[nodiscard]] Eigen::MatrixXd strain_slopes(const TileMotion& motion) const {
        const auto size = static_cast<std::size_t>(motion.nodes.size());
        std::vector<mechanics::NodeIndex> nodes;
        for (Eigen::Index i = 0; i < motion.nodes.rows(); ++i) nodes.emplace_back(static_cast<int>(i));
        const auto element = mechanics::corotational_element(nodes, body(), motion.turn);
        const Eigen::VectorXd given = Eigen::VectorXd::Zero(motion.nodes.size());
        Eigen::VectorXd found(motion.nodes.size());
        Eigen::MatrixXd slopes(motion.nodes.size(), motion.nodes.size());
        mechanics::MixedResponse response;
        element->evaluate_mixed(mechanics::node_states(motion.nodes), mechanics::Demand::Tangent,
                                {{given.data(), size}, {found.data(), size}, {slopes.data(), size * size}},
                                response);
        return slopes;
    }

    /// Transform rows in the corotating axes to displacements and rotations in the surface's axes.
    [[nodiscard]] NodeValues carried(const NodeValues& rows, const CorotationalMotion& moved,
                                     const Eigen::Matrix3d& turn) const {
        NodeValues result(rows.rows(), kDofsPerNode);
        for (Eigen::Index i = 0; i < rows.rows(); ++i) {
            const Eigen::Vector3d arm = inner_->places()[i] - mean_;
            const Eigen::Vector3d arm_now = arm + rows.row(i).head<3>().transpose();
            result.row(i).head<3>() = (moved.shift + moved.axes * arm_now - turn * arm).transpose();
            const Eigen::Quaterniond spin = geometry::exponential(rows.row(i).tail<3>().transpose());
            const Eigen::Matrix3d rotation = moved.axes * spin.toRotationMatrix() * turn.transpose();
            result.row(i).tail<3>() = geometry::logarithm(Eigen::Quaterniond(rotation)).transpose();
        }
        return result;
    }

    Eigen::Vector3d mean_;  ///< mean position of the interface nodes, m
    std::shared_ptr<const InnerNodes> inner_;
};

}  // namespace

std::shared_ptr<const TileStructure> corotational_tile(mechanics::Frame tile, int interface_nodes) {
    const auto inner = std::make_shared<const InnerNodes>(std::move(tile), interface_nodes);
    const auto& nodes = inner->tile().nodes;
    mechanics::CorotationalBody::Parts parts{{nodes.begin(), nodes.begin() + interface_nodes},
                                             condensed_frame(inner->tile(), interface_nodes)};
    detail::require_small_rounding(parts.stiffness, inner->tile(), interface_nodes);
    parts.mass = [inner] {
        return mechanics::condense_mass(mechanics::assemble(inner->tile()),
                                        mechanics::first_nodes(inner->interface_nodes()));
    };
    return std::make_shared<CorotationalTile>(std::move(parts), inner);
}

std::shared_ptr<const TileStructure> corotational_tile(mechanics::CorotationalBody::Parts parts) {
    return std::make_shared<BodyTile>(std::move(parts));
}

TileModel corotational_tile_model() {
    return {.name = "corotational",
            .summary = "the condensed stiffness of each tile in axes that turn with it; large displacements",
            .displacements = Displacements::Large,
            .sharing = Sharing::Congruent,
            .build = [](const TileInput& input) {
                return corotational_tile(fan_frame(input.layout, input.fan, input.polygon, input.setting),
                                         input.fan->interface_node_count);
            }};
}

}  // namespace fretwork::reduction

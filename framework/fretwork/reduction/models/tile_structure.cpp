// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/linear_element.hpp>
#include <fretwork/reduction/models/tile_structure.hpp>

#include <utility>
#include <vector>

namespace fretwork::reduction {
namespace {

using mechanics::kDofsPerNode;
using mechanics::NodeIndex;

class BeamTile final : public TileStructure {
  public:
    BeamTile(mechanics::Frame frame, int interface_nodes, TileBeams beams)
        : frame_(std::move(frame)), interface_nodes_(interface_nodes), beams_(beams) {}

    [[nodiscard]] std::span<const Eigen::Vector3d> inner_nodes() const override {
        return std::span(frame_.nodes).subspan(interface_nodes_);
    }

    void add_to(StructureParts& surface, const TilePlace& place) const override {
        for (mechanics::Beam beam : frame_.beams) {
            for (NodeIndex& node : beam.nodes) node = place.nodes[node];
            if (beam.normal) beam.normal = place.turn * *beam.normal;
            surface.beams.beams.push_back(std::move(beam));
        }
    }

    [[nodiscard]] std::optional<BeamMotion> beam_motion(const TileMotion& motion) const override {
        if (beams_ == TileBeams::Substitutes) return std::nullopt;
        return BeamMotion{.nodes = motion.nodes, .displacements = motion.displacements};
    }

  private:
    mechanics::Frame frame_;
    std::size_t interface_nodes_;
    TileBeams beams_;
};

class StiffnessTile final : public TileStructure {
  public:
    StiffnessTile(Eigen::MatrixXd stiffness, std::shared_ptr<const InnerNodes> inner)
        : stiffness_(std::move(stiffness)), inner_(std::move(inner)) {}

    [[nodiscard]] std::span<const Eigen::Vector3d> inner_nodes() const override { return {}; }

    void add_to(StructureParts& surface, const TilePlace& place) const override {
        surface.elements.push_back(mechanics::linear_element({place.nodes.begin(), place.nodes.end()},
                                                             {.stiffness = turned(place.turn)}));
    }

    /// The motion by linear theory, whatever the theory of the solution.
    [[nodiscard]] std::optional<BeamMotion> beam_motion(const TileMotion& motion) const override {
        if (!inner_) return std::nullopt;
        return condensed_motion(*inner_, motion);
    }

    [[nodiscard]] std::optional<mechanics::NodeValues> motion_gradient(
        const TileMotion& motion, const mechanics::NodeValues& by_beams) const override {
        if (!inner_) return std::nullopt;
        return reduction::turned(condensed_gradient(*inner_, motion.turn, by_beams), motion.turn);
    }

  private:
    /// The stiffness in other axes, block by block of three components.
    [[nodiscard]] Eigen::MatrixXd turned(const Eigen::Matrix3d& turn) const {
        if (turn.isIdentity(0.0)) return stiffness_;
        Eigen::MatrixXd result(stiffness_.rows(), stiffness_.cols());
        for (Eigen::Index i = 0; i < stiffness_.rows(); i += 3) {
            for (Eigen::Index j = 0; j < stiffness_.cols(); j += 3)
                result.block<3, 3>(i, j) = turn * stiffness_.block<3, 3>(i, j) * turn.transpose();
        }
        return result;
    }

    Eigen::MatrixXd stiffness_;
    std::shared_ptr<const InnerNodes> inner_;
};

}  // namespace

BeamMotion condensed_motion(const InnerNodes& inner, const TileMotion& motion) {
    const mechanics::NodeValues followed = inner.follow(turned(motion.nodes, motion.turn.transpose()));
    BeamMotion beams;
    beams.nodes.resize(motion.nodes.rows() + followed.rows(), kDofsPerNode);
    beams.nodes << motion.nodes, turned(followed, motion.turn);
    return beams;
}

mechanics::NodeValues condensed_gradient(const InnerNodes& inner, const Eigen::Matrix3d& turn,
                                         const mechanics::NodeValues& by_beams) {
    const mechanics::NodeValues own = turned(by_beams, turn.transpose());
    const Eigen::Index interface_nodes = inner.interface_nodes();
    return own.topRows(interface_nodes) + inner.pull_back(own.bottomRows(own.rows() - interface_nodes));
}

mechanics::NodeValues turned(const mechanics::NodeValues& rows, const Eigen::Matrix3d& turn) {
    mechanics::NodeValues result(rows.rows(), kDofsPerNode);
    result.leftCols<3>().noalias() = rows.leftCols<3>() * turn.transpose();
    result.rightCols<3>().noalias() = rows.rightCols<3>() * turn.transpose();
    return result;
}

std::shared_ptr<const TileStructure> beam_tile(mechanics::Frame frame, int interface_nodes, TileBeams beams) {
    return std::make_shared<BeamTile>(std::move(frame), interface_nodes, beams);
}

std::shared_ptr<const TileStructure> stiffness_tile(Eigen::MatrixXd stiffness,
                                                    std::shared_ptr<const InnerNodes> inner) {
    if (stiffness.rows() != stiffness.cols() || stiffness.rows() % kDofsPerNode != 0)
        throw base::InputError(
            "the stiffness of a tile has six rows and columns for each interface node, not " +
            std::to_string(stiffness.rows()) + " x " + std::to_string(stiffness.cols()));
    return std::make_shared<StiffnessTile>(std::move(stiffness), std::move(inner));
}

mechanics::Assembly assemble(const StructureParts& parts, const base::Control& control) {
    mechanics::Assembly assembly;
    if (!parts.beams.beams.empty()) {
        assembly = mechanics::assemble(parts.beams, {.control = control});
    } else {
        assembly.nodes = parts.beams.nodes;
        assembly.reported_nodes = static_cast<int>(assembly.nodes.size());
        assembly.loads = mechanics::NodeValues::Zero(assembly.reported_nodes, kDofsPerNode);
        assembly.has_moments = false;
    }
    assembly.elements.insert(assembly.elements.end(), parts.elements.begin(), parts.elements.end());
    return assembly;
}

StructureParts tile_parts(const TileStructure& tile, std::span<const Eigen::Vector3d> interface_nodes) {
    StructureParts parts;
    parts.beams.nodes.assign(interface_nodes.begin(), interface_nodes.end());
    const auto inner = tile.inner_nodes();
    parts.beams.nodes.insert(parts.beams.nodes.end(), inner.begin(), inner.end());
    std::vector<NodeIndex> nodes;
    for (std::size_t i = 0; i < parts.beams.nodes.size(); ++i) nodes.emplace_back(i);
    tile.add_to(parts, {.nodes = nodes});
    return parts;
}

}  // namespace fretwork::reduction

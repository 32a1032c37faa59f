// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/pattern/fan.hpp>
#include <fretwork/reduction/detail/rigid_motions.hpp>

#include <array>
#include <vector>

namespace fretwork::reduction::detail {
namespace {

using mechanics::kDofsPerNode;

/// The largest force on a rigid motion, as a share of the largest entry of the stiffness. The rounding of
/// condensed tiles (304 patterns of paper7 in hexagons with sides of 26 mm, regular and stretched) leaves
/// 2e-13 with bars of 2 mm, 2e-11 with 0.2 mm and 2e-7 with 2 micrometres. The softest deformation of these
/// tiles has 3e-5 with bars of 2 mm.
constexpr double kFree = 1e-6;

constexpr std::array<const char*, 6> kMotions = {"translation along x", "translation along y",
                                                 "translation along z", "rotation about x",
                                                 "rotation about y",    "rotation about z"};

/// The rigid motions of nodes about their mean, one in each column. Rotations are scaled by the radius, so
/// that all entries of a scaled stiffness are in N/m.
struct RigidMotions {
    Eigen::MatrixXd columns;
    Eigen::VectorXd lengths;  ///< scale of each component: 1 for displacements, 1 / radius for rotations
};

RigidMotions rigid_motions(const Eigen::Matrix3Xd& nodes) {
    const Eigen::Matrix3Xd arms = nodes.colwise() - nodes.rowwise().mean().eval();
    const double radius = arms.colwise().norm().maxCoeff();
    const double inverse = radius > 0.0 ? 1.0 / radius : 1.0;
    RigidMotions rigid{Eigen::MatrixXd::Zero(kDofsPerNode * arms.cols(), 6),
                       Eigen::VectorXd::Ones(kDofsPerNode * arms.cols())};
    for (Eigen::Index i = 0; i < arms.cols(); ++i) {
        const Eigen::Index row = kDofsPerNode * i;
        rigid.columns.block<3, 3>(row, 0).setIdentity();
        for (int axis = 0; axis < 3; ++axis) {
            const Eigen::Vector3d turn = Eigen::Vector3d::Unit(axis);
            rigid.columns.block<3, 1>(row, 3 + axis) = inverse * turn.cross(arms.col(i));
        }
        rigid.columns.block<3, 3>(row + 3, 3)
            .setIdentity();  // components that are rotations times the radius
        rigid.lengths.segment<3>(row + 3).setConstant(inverse);
    }
    return rigid;
}

void require_free(Eigen::MatrixXd stiffness, const Eigen::Matrix3Xd& nodes, const std::string& model) {
    const std::string what = "tile model " + model + ": the stiffness of a tile ";
    if (!stiffness.allFinite()) throw base::InputError(what + "is not finite");
    const RigidMotions rigid = rigid_motions(nodes);
    stiffness = rigid.lengths.asDiagonal() * stiffness * rigid.lengths.asDiagonal();
    const double largest = stiffness.cwiseAbs().maxCoeff();
    const Eigen::RowVectorXd forces = (stiffness * rigid.columns).cwiseAbs().colwise().maxCoeff();
    const double force = forces.maxCoeff();
    if (force <= kFree * largest) return;
    // Often several motions are resisted equally, up to rounding. In this case, the simplest motion is named.
    Eigen::Index worst = 0;
    while (forces[worst] < (1.0 - kFree) * force) ++worst;
    throw base::InputError(what + "resists a rigid motion, the " + kMotions[worst] + ": its force is " +
                           base::format_number(force / largest) +
                           " of the largest entry, where rounding leaves " + base::format_number(kFree) +
                           " at most; is it in the tile's own axes?");
}

}  // namespace

void require_free_motion(const TileStructure& tile, const TileModel& model, const TileInput& input) {
    const auto places = pattern::place_fan(input.layout, input.fan, input.polygon);
    std::vector<Eigen::Vector3d> interface_nodes;
    for (int i = 0; i < input.fan->interface_node_count; ++i) {
        const geometry::Point2& place = places[i];
        interface_nodes.emplace_back(place.x, place.y, 0.0);
    }
    const StructureParts parts = tile_parts(tile, interface_nodes);
    Eigen::MatrixXd stiffness;
    for (const auto& element : parts.elements) {
        const auto ends = element->nodes();
        Eigen::Matrix3Xd nodes(3, static_cast<Eigen::Index>(ends.size()));
        for (std::size_t i = 0; i < ends.size(); ++i)
            nodes.col(static_cast<Eigen::Index>(i)) = parts.beams.nodes[ends[i]];
        element->rest_stiffness(stiffness);
        require_free(stiffness, nodes, model.name);
    }
}

}  // namespace fretwork::reduction::detail

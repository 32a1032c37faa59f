// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/pattern/fan.hpp>
#include <fretwork/reduction/detail/rigid_motions.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace fretwork::reduction::detail {
namespace {

using mechanics::kDofsPerNode;

/// The largest force that may resist a rigid motion, as a share of the stiffness's largest entry. Rounding of
/// condensed tiles (304 patterns of paper7 in hexagons with sides of 26 mm, regular and stretched) leaves
/// 2e-13 with bars of 2 mm, 2e-11 with 0.2 mm and 2e-7 with 2 micrometres. The softest deformation of these
/// tiles has 3e-5 with bars of 2 mm.
constexpr double kFree = 1e-6;

constexpr std::array<const char*, 6> kMotions = {"translation along x", "translation along y",
                                                 "translation along z", "rotation about x",
                                                 "rotation about y",    "rotation about z"};

/// The rigid motion that a stiffness resists most, and its force as a share of the stiffness's largest entry.
struct Resistance {
    const char* motion;
    double share;
};

/// None if the force may be due to rounding.
std::optional<Resistance> resistance_of(const Eigen::MatrixXd& stiffness, const Eigen::Matrix3Xd& nodes) {
    const Eigen::Matrix3Xd arms = nodes.colwise() - nodes.rowwise().mean().eval();
    const double radius = arms.colwise().norm().maxCoeff();
    // Rotations times the radius are lengths, so that all entries are in N/m.
    const double scale = radius > 0.0 ? radius : 1.0;
    Eigen::VectorXd lengths = Eigen::VectorXd::Ones(stiffness.rows());
    for (Eigen::Index node = 0; node < arms.cols(); ++node)
        lengths.segment<3>(kDofsPerNode * node + 3).setConstant(1.0 / scale);
    Eigen::MatrixXd motions = geometry::rigid_motions(arms);
    motions.rightCols<3>() /= scale;
    const Eigen::RowVectorXd forces =
        (lengths.asDiagonal() * stiffness * motions).cwiseAbs().colwise().maxCoeff();
    const double largest = (lengths.asDiagonal() * stiffness * lengths.asDiagonal()).cwiseAbs().maxCoeff();
    const double force = forces.maxCoeff();
    if (force <= kFree * largest) return std::nullopt;
    // Often several motions are resisted equally, up to rounding. In this case, the simplest motion is named.
    Eigen::Index worst = 0;
    while (forces[worst] < (1.0 - kFree) * force) ++worst;
    return Resistance{kMotions[worst], force / largest};
}

void require_free(const Eigen::MatrixXd& stiffness, const Eigen::Matrix3Xd& nodes, const std::string& model) {
    const std::string what = "tile model " + model + ": the stiffness of a tile ";
    if (!stiffness.allFinite()) throw base::InputError(what + "is not finite");
    const auto resistance = resistance_of(stiffness, nodes);
    if (!resistance) return;
    throw base::InputError(what + "resists a rigid motion, the " + resistance->motion + ": its force is " +
                           base::format_number(resistance->share) +
                           " of the largest entry, where rounding leaves " + base::format_number(kFree) +
                           " at most; the stiffness must be given in the axes of the tile");
}

/// The smallest ratio of thickness to length, where a bar counts as a rectangle.
double smallest_thickness(const mechanics::Frame& tile) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const mechanics::Beam& bar : tile.beams) {
        const double length = (tile.nodes[bar.nodes[1]] - tile.nodes[bar.nodes[0]]).norm();
        const double thickness =
            std::sqrt(12.0 * std::min(bar.section.I2, bar.section.I3) / bar.section.area);
        smallest = std::min(smallest, thickness / length);
    }
    return smallest;
}

}  // namespace

void require_small_rounding(const Eigen::MatrixXd& stiffness, const mechanics::Frame& tile,
                            int interface_nodes) {
    Eigen::Matrix3Xd nodes(3, interface_nodes);
    for (int i = 0; i < interface_nodes; ++i) nodes.col(i) = tile.nodes[i];
    const auto resistance = resistance_of(stiffness, nodes);
    if (!resistance) return;
    throw base::NumericalError(
        "the bars are too thin to be condensed: the thinnest is " +
        base::format_number(smallest_thickness(tile), 2) +
        " of its length thick. By rounding, the tile resists the " + std::string(resistance->motion) + " (" +
        base::format_number(resistance->share, 2) + "; " + base::format_number(kFree, 2) +
        " at most): make bars thicker or shorter, or check the section's unit");
}

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

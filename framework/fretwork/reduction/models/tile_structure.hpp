// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/corotational_element.hpp>
#include <fretwork/mechanics/frame/frame.hpp>
#include <fretwork/reduction/models/inner_nodes.hpp>

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <span>

namespace fretwork::reduction {

/// The components of a surface: its beams, and elements of other kinds between the same nodes.
struct StructureParts {
    mechanics::Frame beams;        ///< the beams, and all nodes of the surface; no supports, no loads
    mechanics::Elements elements;  ///< elements of tiles that do not consist of beams
};

/// The place of a tile in a surface: its orientation and its nodes.
struct TilePlace {
    /// The rotation about z from the axes in which the tile was built to the axes of the surface.
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    /// The tile's interface nodes in order, then its inner nodes.
    std::span<const mechanics::NodeIndex> nodes;
};

/// The size of the displacements for which a tile model is made, or which the theory of a solution allows.
enum class Displacements {
    Small,  ///< linear theory
    Large   ///< displacements and rotations of any size
};

/// The motion of a tile's own nodes in a solution.
struct TileMotion {
    mechanics::NodeValues nodes;  ///< one row for each interface node, then one row for each inner node
    /// The rotation about z from the axes in which the tile was built to the axes of the surface. The rows of
    /// `nodes` are in the axes of the surface.
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    /// Size of the displacements that the theory of the solution allows.
    Displacements displacements = Displacements::Small;
};

/// The motion of the beams of a tile's pattern, as rows for the nodes of the beams, interface nodes first.
struct BeamMotion {
    mechanics::NodeValues nodes;  ///< one row for each node, in the surface's axes
    /// For a tile that is linear in corotating axes: one row for each node, its small displacement relative
    /// to these axes. The components are in the surface's axes, as if the tile had not turned. The strains of
    /// the beams follow from `in_axes` or, if it is empty, from `nodes`.
    mechanics::NodeValues in_axes{};
    /// Theory by which the strains of the beams follow from the rows.
    Displacements displacements = Displacements::Small;
};

/// A tile as built by a tile model, in its own axes. Congruent tiles may share one TileStructure (see
/// Sharing). It is immutable, so threads may share it, too.
class TileStructure {
  public:
    TileStructure() = default;
    TileStructure(const TileStructure&) = delete;
    TileStructure& operator=(const TileStructure&) = delete;
    virtual ~TileStructure() = default;

    /// The rest positions of the tile's inner nodes, m, in the tile's own axes.
    [[nodiscard]] virtual std::span<const Eigen::Vector3d> inner_nodes() const = 0;

    /// Add the tile's beams and elements to a surface. Pre: the surface has the tile's nodes. Throws
    /// InputError if a stiffness of the tile does not fit the number of nodes.
    virtual void add_to(StructureParts& surface, const TilePlace& place) const = 0;

    /// The motion of the pattern's beams; nothing if the tile model does not know this motion, or if no
    /// corotating axes exist (see mechanics::corotational_motion()).
    [[nodiscard]] virtual std::optional<BeamMotion> beam_motion(const TileMotion& motion) const = 0;

    /// The gradient of a function of beam_motion() with respect to the rows of `motion.nodes`. `by_beams` is
    /// the gradient of the function with respect to the rows from which the strains of the beams follow:
    /// BeamMotion::in_axes, or BeamMotion::nodes if `in_axes` is empty. Nothing if the tile model does not
    /// know this gradient.
    [[nodiscard]] virtual std::optional<mechanics::NodeValues> motion_gradient(
        const TileMotion& /*motion*/, const mechanics::NodeValues& /*by_beams*/) const {
        return std::nullopt;
    }

    /// The corotational body of the tile, with the linear stiffness for large displacements. Null for a tile
    /// of another kind, which has no derivatives with respect to such a stiffness.
    [[nodiscard]] virtual const mechanics::CorotationalBody* corotational_body() const { return nullptr; }
};

/// The kind of a tile's beams.
enum class TileBeams {
    OfThePattern,  ///< beams of the pattern, in the order of its fan
    Substitutes    ///< other beams that replace the beams of the pattern
};

/// A tile of beams. The first `interface_nodes` nodes of the frame are the tile's interface nodes. The
/// frame's supports and loads are ignored.
std::shared_ptr<const TileStructure> beam_tile(mechanics::Frame frame, int interface_nodes,
                                               TileBeams beams = TileBeams::Substitutes);

/// A tile given by its stiffness (6n x 6n, in its own axes) for small displacements of its n interface nodes.
/// The tile has no inner nodes. Throws InputError unless the stiffness is square with a multiple of six rows.
///
/// @param inner  the motion of the beams that were condensed; null: not known
std::shared_ptr<const TileStructure> stiffness_tile(Eigen::MatrixXd stiffness,
                                                    std::shared_ptr<const InnerNodes> inner = nullptr);

/// The motion of a tile's condensed beams at small displacements. Throws as InnerNodes::follow().
BeamMotion condensed_motion(const InnerNodes& inner, const TileMotion& motion);
/// The gradient of a function of condensed_motion() with respect to the rows of the interface nodes, in the
/// tile's own axes. Throws as InnerNodes::follow().
/// @param turn      rotates the tile's own axes to the surface's axes
/// @param by_beams  the gradient of the function with respect to the rows of the beams' nodes, in the
/// surface's axes
mechanics::NodeValues condensed_gradient(const InnerNodes& inner, const Eigen::Matrix3d& turn,
                                         const mechanics::NodeValues& by_beams);

/// Rows of displacements and rotation vectors, rotated by `turn`.
mechanics::NodeValues turned(const mechanics::NodeValues& rows, const Eigen::Matrix3d& turn);

/// The components as one assembly for the solvers: the elements of the beams come first, and all other
/// elements follow. Throws as mechanics::assemble, and Stopped.
mechanics::Assembly assemble(const StructureParts& parts, const base::Control& control = {});

/// The components of a single tile. The first nodes are the interface nodes, whose rest positions (m) are
/// given. Throws as TileStructure::add_to().
StructureParts tile_parts(const TileStructure& tile, std::span<const Eigen::Vector3d> interface_nodes);

}  // namespace fretwork::reduction

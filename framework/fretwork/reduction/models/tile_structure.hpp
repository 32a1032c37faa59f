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
    mechanics::Frame beams;        ///< holds all nodes of the surface
    mechanics::Elements elements;  ///< elements of tiles that do not consist of beams
};

/// The place of a tile in a surface: its orientation and its nodes.
struct TilePlace {
    /// The rotation about z from the axes in which the tile was built to those of the surface.
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    std::span<const mechanics::NodeIndex> nodes;  ///< its interface nodes in order, then its inner nodes
};

/// The size of the displacements that a tile model is made for, or that a solution allows.
enum class Displacements { Small, Large };

/// The motion of a tile's own nodes in a solution.
struct TileMotion {
    mechanics::NodeValues nodes;  ///< a row for each interface node, then for each inner node
    /// The rotation about z from the axes in which the tile was built to those of the surface, in which the
    /// rows are given.
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    Displacements displacements = Displacements::Small;  ///< size of the displacements in the solution
};

/// The motion of the beams of a tile's pattern: a row for each of their nodes, interface nodes first.
struct BeamMotion {
    mechanics::NodeValues nodes;  ///< in the surface's axes
    /// For a tile that is linear in corotating axes: the small displacements relative to those axes, given in
    /// the surface's axes at rest. The strains of the beams follow from them. Empty: the strains follow from
    /// `nodes`.
    mechanics::NodeValues in_frame{};
    Displacements displacements = Displacements::Small;  ///< the theory by which strains of beams follow from
                                                         ///< these rows
};

/// A tile as a tile model builds it, independent of its place. Congruent tiles share it. It is immutable, so
/// threads may share it, too.
class TileStructure {
  public:
    TileStructure() = default;
    TileStructure(const TileStructure&) = delete;
    TileStructure& operator=(const TileStructure&) = delete;
    virtual ~TileStructure() = default;

    /// The rest positions of the tile's inner nodes, in metres and in its own axes.
    [[nodiscard]] virtual std::span<const Eigen::Vector3d> inner_nodes() const = 0;

    /// Add the tile's beams and elements to a surface. The surface has the tile's nodes already.
    virtual void add_to(StructureParts& surface, const TilePlace& place) const = 0;

    /// The motion of the pattern's beams. Nothing if the tile model does not know it.
    [[nodiscard]] virtual std::optional<BeamMotion> beam_motion(const TileMotion& motion) const = 0;

    /// The gradient of a function of beam_motion() by the rows of `motion.nodes`, from that by the rows that
    /// the beams answer to (`in_frame` if it has any, else `nodes`). Nothing if the model does not give it.
    [[nodiscard]] virtual std::optional<mechanics::NodeValues> motion_gradient(
        const TileMotion& /*motion*/, const mechanics::NodeValues& /*by_beams*/) const {
        return std::nullopt;
    }

    /// The corotational body of the tile, whose linear stiffness governs large displacements. Null for other
    /// tiles; derivatives with respect to that stiffness do not exist for them.
    [[nodiscard]] virtual const mechanics::CorotationalBody* corotational_body() const { return nullptr; }
};

/// The meaning of a tile's beams: OfThePattern are the beams of its pattern in the order of its fan;
/// Substitutes are other beams in their place.
enum class TileBeams { OfThePattern, Substitutes };

/// A tile of beams. The first `interface_nodes` nodes of the frame are the tile's interface nodes. The
/// frame's supports and loads are ignored.
std::shared_ptr<const TileStructure> beam_tile(mechanics::Frame frame, int interface_nodes,
                                               TileBeams beams = TileBeams::Substitutes);

/// A tile given by its stiffness (6n x 6n, in its own axes) for small displacements of its n interface nodes.
/// It has no inner nodes. Throws InputError unless the stiffness has 6n rows and columns.
///
/// @param inner  the motion of the condensed beams; null: not known
std::shared_ptr<const TileStructure> stiffness_tile(Eigen::MatrixXd stiffness,
                                                    std::shared_ptr<const InnerNodes> inner = nullptr);

/// The motion, at small displacements, of the beams that were condensed into a tile.
BeamMotion condensed_motion(const InnerNodes& inner, const TileMotion& motion);
/// The gradient of a function of that motion by the interface nodes' rows in the tile's own axes.
/// @param by_beams  its gradient by the rows of the beams' nodes, in axes that `turn` leads to
mechanics::NodeValues condensed_gradient(const InnerNodes& inner, const Eigen::Matrix3d& turn,
                                         const mechanics::NodeValues& by_beams);

/// Rows of displacements and rotation vectors, rotated by `turn`.
mechanics::NodeValues turned(const mechanics::NodeValues& rows, const Eigen::Matrix3d& turn);

/// The components as one assembly for the solvers: the elements of the beams come first, then the others.
/// Throws as mechanics::assemble, and Stopped.
mechanics::Assembly assemble(const StructureParts& parts, const base::Control& control = {});

/// The components of a single tile. Its first nodes are the interface nodes.
StructureParts tile_parts(const TileStructure& tile, std::span<const Eigen::Vector3d> interface_nodes);

}  // namespace fretwork::reduction

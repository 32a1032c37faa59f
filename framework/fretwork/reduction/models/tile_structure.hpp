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

/// The components of a surface: beams, and elements of other kinds between the same nodes.
struct StructureParts {
    mechanics::Frame beams;        ///< with all nodes of the surface
    mechanics::Elements elements;  ///< of tiles that are no beams
};

/// Where a tile lies in a surface, and which of the surface's nodes are its own.
struct TilePlace {
    /// The turn about z from the axes that the tile was built in to those of the surface.
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    std::span<const mechanics::NodeIndex> nodes;  ///< its interface nodes in order, then its inner nodes
};

/// Which displacements a tile model is made for, or a solution is sought in.
enum class Displacements { Small, Large };

/// How a tile has moved: what its own nodes do in a solution.
struct TileMotion {
    mechanics::NodeValues nodes;  ///< a row for each interface node, then for each inner node
    /// The turn about z from the axes that the tile was built in to those of the surface, and of the rows.
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    Displacements displacements = Displacements::Small;  ///< of the solution
};

/// How the beams of a tile's pattern have moved: a row for each of their nodes, interface nodes first.
struct BeamMotion {
    mechanics::NodeValues nodes;  ///< in the surface's axes
    /// Where the tile answers linearly in a frame that turns with it: the same seen from that frame, in the
    /// surface's axes at rest. Beams answer to these small displacements. Empty: to `nodes`.
    mechanics::NodeValues in_frame{};
    Displacements displacements = Displacements::Small;  ///< how the beams answer to these rows
};

/// A tile as a tile model makes it, wherever the tile lies: congruent tiles share it. Immutable, so that
/// threads may share it, too.
class TileStructure {
  public:
    TileStructure() = default;
    TileStructure(const TileStructure&) = delete;
    TileStructure& operator=(const TileStructure&) = delete;
    virtual ~TileStructure() = default;

    /// The rest positions of the nodes that it has besides the interface nodes: metres, in its own axes.
    [[nodiscard]] virtual std::span<const Eigen::Vector3d> inner_nodes() const = 0;

    /// Add what it consists of to a surface. The surface has its nodes already.
    virtual void add_to(StructureParts& surface, const TilePlace& place) const = 0;

    /// The motions of the pattern's beams. Nothing if the model does not give them.
    [[nodiscard]] virtual std::optional<BeamMotion> beam_motion(const TileMotion& motion) const = 0;

    /// The body whose linear stiffness is the tile's answer in large displacements; null for tiles that
    /// answer in another way, of which no derivatives by that stiffness are given.
    [[nodiscard]] virtual const mechanics::CorotationalBody* corotational_body() const { return nullptr; }
};

/// Whether the beams of a tile are those of its pattern, in the order of its fan, or stand for them.
enum class TileBeams { OfThePattern, Substitutes };

/// A tile of beams. The first `interface_nodes` nodes of the frame are the tile's interface nodes; its
/// supports and loads are left aside.
std::shared_ptr<const TileStructure> beam_tile(mechanics::Frame frame, int interface_nodes,
                                               TileBeams beams = TileBeams::Substitutes);

/// A tile that answers to small displacements of its n interface nodes with a stiffness (6n x 6n, in its own
/// axes) and has no inner nodes. Throws InputError unless the stiffness has 6n rows and columns.
///
/// @param inner  how the beams that were condensed follow; null: not known
std::shared_ptr<const TileStructure> stiffness_tile(Eigen::MatrixXd stiffness,
                                                    std::shared_ptr<const InnerNodes> inner = nullptr);

/// How the beams move that were condensed into a tile, at small displacements.
BeamMotion condensed_motion(const InnerNodes& inner, const TileMotion& motion);

/// Rows of displacements and rotation vectors in other axes.
mechanics::NodeValues turned(const mechanics::NodeValues& rows, const Eigen::Matrix3d& turn);

/// The parts as the solvers see them: the elements of the beams come first, then the others. Throws as
/// mechanics::assemble, and Stopped.
mechanics::Assembly assemble(const StructureParts& parts, const base::Control& control = {});

/// A tile alone, with its interface nodes first.
StructureParts tile_parts(const TileStructure& tile, std::span<const Eigen::Vector3d> interface_nodes);

}  // namespace fretwork::reduction

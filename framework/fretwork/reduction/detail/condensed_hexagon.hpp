// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/detail/hexagon_blocks.hpp>

#include <Eigen/Core>

namespace fretwork::reduction::detail {

/// Three components of each of six nodes, the interface nodes or the ring nodes, one column for each node.
using NodeColumns = Eigen::Matrix<double, 3, kSectors>;
/// A stiffness of the six interface nodes in one plane, node by node.
using PlaneStiffness = Eigen::Matrix<double, 3 * kSectors, 3 * kSectors>;

/// A symmetric block-circulant matrix: block (i, j) is blocks[(j - i) mod 6], so that blocks d and 6 - d are
/// each other's transpose.
struct BlockCirculant {
    std::array<Eigen::Matrix3d, kSectors> blocks;
    [[nodiscard]] NodeColumns apply(const NodeColumns& columns) const;
};

/// The hexagon's problem in one plane, with the ring nodes eliminated. Blocks and columns are in the nodes'
/// own axes.
class CondensedHexagon {
  public:
    explicit CondensedHexagon(const HexagonBlocks& blocks);

    /// The stiffness of the interface nodes, in their own axes.
    [[nodiscard]] BlockCirculant stiffness() const;
    /// The displacements of the ring nodes that follow from displacements of the interface nodes.
    [[nodiscard]] NodeColumns ring_displacements(const NodeColumns& interface) const;
    /// The forces dS u, where dS is the change of the condensed stiffness by a change of the blocks.
    [[nodiscard]] NodeColumns changed_forces(const HexagonBlocks& change, const NodeColumns& interface,
                                             const NodeColumns& ring) const;
    /// Add the derivatives of a^T S u with respect to each entry of the blocks. `one` and `other` are a and
    /// u, displacements of the interface nodes.
    void add_work(const NodeColumns& one, const NodeColumns& other, HexagonBlocks& sum) const;

  private:
    HexagonBlocks blocks_;
    BlockCirculant ring_inverse_;
};

}  // namespace fretwork::reduction::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>
#include <fretwork/mechanics/results/solution.hpp>

#include <Eigen/Core>

#include <mutex>
#include <span>

namespace fretwork::reduction {

/// How the inner nodes of a tile's beams follow its interface nodes, statically: what condensation leaves
/// out. Computed when it is first asked for; threads may share it.
class InnerNodes {
  public:
    /// @param tile  its first `interface_nodes` nodes are the interface nodes
    InnerNodes(mechanics::Frame tile, int interface_nodes);
    InnerNodes(const InnerNodes&) = delete;
    InnerNodes& operator=(const InnerNodes&) = delete;
    ~InnerNodes() = default;

    [[nodiscard]] const mechanics::Frame& tile() const { return tile_; }
    [[nodiscard]] int interface_nodes() const { return interface_nodes_; }
    /// Their places at rest, m, in the tile's own axes.
    [[nodiscard]] std::span<const Eigen::Vector3d> places() const;
    /// A row for each of them, from one for each interface node: small displacements in the tile's own axes.
    [[nodiscard]] mechanics::NodeValues follow(const mechanics::NodeValues& interface_nodes) const;

  private:
    mechanics::Frame tile_;
    int interface_nodes_;
    mutable std::once_flag computed_;
    mutable Eigen::MatrixXd matrix_;  ///< six rows an inner node, six columns an interface node
};

}  // namespace fretwork::reduction

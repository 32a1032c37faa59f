// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>
#include <fretwork/mechanics/results/solution.hpp>

#include <Eigen/Core>

#include <mutex>
#include <span>

namespace fretwork::reduction {

/// The static motion of a tile's inner nodes, which condensation eliminates, for a given motion of its
/// interface nodes. The matrix of this motion is computed at the first use. Threads may share an InnerNodes.
class InnerNodes {
  public:
    /// @param tile  the tile's beams; the first `interface_nodes` nodes are the interface nodes
    InnerNodes(mechanics::Frame tile, int interface_nodes);
    InnerNodes(const InnerNodes&) = delete;
    InnerNodes& operator=(const InnerNodes&) = delete;
    ~InnerNodes() = default;

    /// The tile's frame, interface nodes first.
    [[nodiscard]] const mechanics::Frame& tile() const { return tile_; }
    /// The number of interface nodes.
    [[nodiscard]] int interface_nodes() const { return interface_nodes_; }
    /// The rest positions of the inner nodes, m, in the tile's own axes.
    [[nodiscard]] std::span<const Eigen::Vector3d> places() const;
    /// The displacements of the inner nodes for given displacements of the interface nodes, with one row for
    /// each node. All displacements are small and in the tile's own axes. Throws as mechanics::assemble() and
    /// mechanics::following().
    [[nodiscard]] mechanics::NodeValues follow(const mechanics::NodeValues& interface_nodes) const;
    /// The transpose of follow(): turns a function's gradient with respect to the inner nodes' rows into its
    /// gradient with respect to the interface nodes' rows. Throws as follow().
    [[nodiscard]] mechanics::NodeValues pull_back(const mechanics::NodeValues& inner_nodes) const;

  private:
    [[nodiscard]] const Eigen::MatrixXd& matrix() const;

    mechanics::Frame tile_;
    int interface_nodes_;
    mutable std::once_flag computed_;
    mutable Eigen::MatrixXd matrix_;  ///< six rows for each inner node, six columns for each interface node
};

}  // namespace fretwork::reduction

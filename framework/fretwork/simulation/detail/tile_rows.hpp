// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/results/surface_beams.hpp>

#include <vector>

namespace fretwork::simulation::detail {

/// The row of a node of the surface's beams among those of its tile: interface nodes, then inner nodes.
class TileRows {
  public:
    TileRows(const tiling::Tessellation& tessellation, const SurfaceBeams& beams, std::size_t tile)
        : interface_(tessellation.tiles[tile].interface_nodes),
          interface_count_(beams.interface_nodes),
          first_inner_(beams.starts[tile].inner_node) {}

    Eigen::Index operator()(mechanics::NodeIndex node) const {
        const std::size_t n = node;
        if (n >= interface_count_) return static_cast<Eigen::Index>(interface_.size() + n - first_inner_);
        Eigen::Index row = 0;
        while (interface_[row].value != node.value) ++row;
        return row;
    }

  private:
    const std::vector<tiling::InterfaceIndex>& interface_;
    std::size_t interface_count_;
    std::size_t first_inner_;
};

}  // namespace fretwork::simulation::detail

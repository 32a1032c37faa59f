// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/sparse/blocks.hpp>

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

namespace fretwork::mechanics::sparse {

/// Sets of nodes. Each set, such as the nodes of an element, couples all of its nodes with one another.
class Cliques {
  public:
    void add(std::span<const int> nodes) {
        node_.insert(node_.end(), nodes.begin(), nodes.end());
        start_.push_back(node_.size());
    }
    [[nodiscard]] std::size_t size() const { return start_.size() - 1; }
    [[nodiscard]] std::span<const int> operator[](std::size_t clique) const {
        return std::span(node_).subspan(start_[clique], start_[clique + 1] - start_[clique]);
    }

  private:
    std::vector<std::size_t> start_{0};
    std::vector<int> node_;
};

/// The graph of coupled nodes.
struct NodeGraph {
    int nodes = 0;
    Cliques cliques;
    std::vector<int> start;      ///< start of each node's neighbours, and the end: nodes + 1 entries
    std::vector<int> neighbour;  ///< the neighbours of node i, at [start[i], start[i + 1]): ascending, in
                                 ///< both directions, without i itself
    std::vector<Eigen::Vector3d> places{};  ///< m, of the nodes; empty: not known
};

/// @param nodes  number of nodes; every node of the cliques is below it
NodeGraph node_graph(int nodes, Cliques cliques);

/// An order of elimination with little fill of the nodes that have unknowns; the others do not appear. The
/// graph of nodes is ordered, not that of unknowns: it is up to six times smaller and gives better orders.
/// Where places are known, an order by nested dissection is made as well, and the one with less fill is
/// taken. Throws Stopped; a thread that still orders a large graph then ends by itself, within seconds, and
/// the program not before it.
std::vector<int> elimination_order(const NodeGraph& graph, std::span<const Components> free,
                                   const base::Control& control = {});

}  // namespace fretwork::mechanics::sparse

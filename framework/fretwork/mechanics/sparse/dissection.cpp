// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/index.hpp>
#include <fretwork/mechanics/sparse/dissection.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace fretwork::mechanics::sparse {
namespace {

using base::at;

/// The largest number of cliques that are not halved any more.
constexpr std::size_t kLeaf = 2;
/// The smallest share of the cliques in the smaller half, and the weight of a cut's distance from the middle
/// against the size of its separator.
constexpr double kSmallestPart = 0.35;
constexpr double kBalance = 1.0;

/// The directions across which cuts are made. The rows of squares, triangles and hexagons are normal to one
/// of these directions.
const Eigen::Vector3d kDirections[] = {{1.0, 0.0, 0.0},
                                       {0.0, 1.0, 0.0},
                                       {0.5, 0.5 * std::sqrt(3.0), 0.0},
                                       {0.5, -0.5 * std::sqrt(3.0), 0.0},
                                       {0.0, 0.0, 1.0}};

class Dissection {
  public:
    Dissection(const NodeGraph& graph, const std::vector<bool>& takes_part, const base::Control& control)
        : graph_(graph),
          control_(control),
          is_open_(takes_part),
          first_(at(graph.nodes), -1),
          last_(first_),
          along_(graph.cliques.size()) {
        for (std::size_t clique = 0; clique < graph.cliques.size(); ++clique) add_clique(clique);
    }

    std::vector<int> run() {
        std::vector<int> all(graph_.cliques.size());
        for (std::size_t clique = 0; clique < all.size(); ++clique) all[clique] = static_cast<int>(clique);
        dissect(all);
        for (int node = 0; node < graph_.nodes; ++node) take(node);  // nodes without a clique
        return std::move(order_);
    }

  private:
    /// A cut, which halves a set of cliques.
    struct Cut {
        std::size_t position = 0;  ///< number of cliques before the cut, in their order along the direction
        double cost = std::numeric_limits<double>::infinity();
    };

    /// Add a clique with its nodes in ascending order, so that the order in which an element lists its nodes
    /// changes nothing, not even rounding.
    void add_clique(std::size_t clique) {
        const std::span<const int> listed = graph_.cliques[clique];
        std::vector<int> nodes(listed.begin(), listed.end());
        std::ranges::sort(nodes);
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const int node : nodes) sum += graph_.places[at(node)];
        middles_.emplace_back(sum / std::max(1.0, static_cast<double>(nodes.size())));
        sorted_.add(nodes);
    }

    [[nodiscard]] std::span<const int> nodes_of(int clique) const { return sorted_[at(clique)]; }

    void take(int node) {
        if (!is_open_[at(node)]) return;
        is_open_[at(node)] = false;
        order_.push_back(node);
    }

    void dissect(std::span<int> cliques) {
        if (cliques.size() <= kLeaf) return take_all(cliques);
        Cut best;
        const Eigen::Vector3d* direction = &kDirections[0];
        for (const Eigen::Vector3d& next : kDirections) {
            control_.check();
            if (!sort_along(next, cliques)) continue;
            const Cut cut = best_cut(cliques);
            if (cut.cost < best.cost) {
                best = cut;
                direction = &next;
            }
        }
        control_.check();
        if (best.position == 0) return take_all(cliques);  // all cliques are at one place
        sort_along(*direction, cliques);
        const std::vector<int> separator = shared_nodes(cliques, best.position, *direction);
        for (const int node : separator) is_open_[at(node)] = false;
        dissect(cliques.first(best.position));
        dissect(cliques.subspan(best.position));
        order_.insert(order_.end(), separator.begin(), separator.end());
    }

    /// Take all nodes of some cliques: nodes of one clique first, then nodes of several.
    void take_all(std::span<const int> cliques) {
        count_places(cliques);
        for (const bool is_shared : {false, true}) {
            for (const int clique : cliques) {
                for (const int node : nodes_of(clique)) {
                    if ((first_[at(node)] != last_[at(node)]) == is_shared) take(node);
                }
            }
        }
    }

    /// Sort cliques along a direction. False, and nothing is sorted, if all of them have the same place along
    /// this direction.
    bool sort_along(const Eigen::Vector3d& direction, std::span<int> cliques) {
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        for (const int clique : cliques) {
            const double place = direction.dot(middles_[at(clique)]);
            along_[at(clique)] = place;
            low = std::min(low, place);
            high = std::max(high, place);
        }
        if (!(high > low)) return false;
        std::sort(cliques.begin(), cliques.end(),
                  [this](int a, int b) { return std::pair(along_[at(a)], a) < std::pair(along_[at(b)], b); });
        return true;
    }

    /// Find the places of the first and the last clique of each node.
    void count_places(std::span<const int> cliques) {
        for (const int clique : cliques) {
            for (const int node : nodes_of(clique)) first_[at(node)] = -1;
        }
        for (std::size_t place = 0; place < cliques.size(); ++place) {
            for (const int node : nodes_of(cliques[place])) {
                if (first_[at(node)] < 0) first_[at(node)] = static_cast<int>(place);
                last_[at(node)] = static_cast<int>(place);
            }
        }
    }

    /// The cut that shares the fewest nodes between nearly equal parts.
    Cut best_cut(std::span<const int> cliques) {
        count_places(cliques);
        // Change of the number of shared nodes from one cut to the next.
        change_.assign(cliques.size() + 1, 0);
        for (std::size_t place = 0; place < cliques.size(); ++place) {
            for (const int node : nodes_of(cliques[place])) {
                if (!is_open_[at(node)] || first_[at(node)] != static_cast<int>(place)) continue;
                ++change_[place + 1];
                --change_[at(last_[at(node)]) + 1];
            }
        }
        const auto size = static_cast<double>(cliques.size());
        Cut best;
        int shared = 0;
        for (std::size_t position = 1; position < cliques.size(); ++position) {
            shared += change_[position];
            const double share = static_cast<double>(position) / size;
            if (std::min(share, 1.0 - share) < kSmallestPart && cliques.size() > 3) continue;
            const double cost = (1.0 + shared) * (1.0 + kBalance * std::abs(share - 0.5));
            if (cost < best.cost) best = {position, cost};
        }
        return best;
    }

    /// The nodes shared across a cut, in their order along the cut, so that neighbours stay neighbours in the
    /// fronts.
    std::vector<int> shared_nodes(std::span<const int> cliques, std::size_t position,
                                  const Eigen::Vector3d& direction) {
        count_places(cliques);
        std::vector<int> shared;
        for (std::size_t place = 0; place < position; ++place) {
            for (const int node : nodes_of(cliques[place])) {
                if (is_open_[at(node)] && first_[at(node)] == static_cast<int>(place) &&
                    last_[at(node)] >= static_cast<int>(position))
                    shared.push_back(node);
            }
        }
        const Eigen::Vector3d line(-direction.y(), direction.x(), 0.0);
        std::stable_sort(shared.begin(), shared.end(), [&](int a, int b) {
            return line.dot(graph_.places[at(a)]) < line.dot(graph_.places[at(b)]);
        });
        return shared;
    }

    const NodeGraph& graph_;
    const base::Control& control_;
    Cliques sorted_;  ///< cliques of the graph, each with ascending nodes
    std::vector<bool> is_open_;
    std::vector<int> first_, last_;
    std::vector<double> along_;
    std::vector<Eigen::Vector3d> middles_;
    std::vector<int> change_;
    std::vector<int> order_;
};

}  // namespace

std::vector<int> dissection_order(const NodeGraph& graph, const std::vector<bool>& takes_part,
                                  const base::Control& control) {
    return Dissection(graph, takes_part, control).run();
}

}  // namespace fretwork::mechanics::sparse

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/index.hpp>
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/nonlinear/unknowns.hpp>
#include <fretwork/mechanics/structure/coupling.hpp>

#include <algorithm>
#include <ranges>
#include <utility>
#include <vector>

namespace fretwork::mechanics::nonlinear {
namespace {

using base::at;

/// The vector of the rotation `to` at the end of the shortest way from another rotation. It is followed in
/// steps, because vectors have no jumps along small steps.
Eigen::Vector3d continued(const Eigen::Quaterniond& from, Eigen::Vector3d vector,
                          const Eigen::Quaterniond& to) {
    constexpr int kSteps = 8;
    const Eigen::Vector3d way = geometry::logarithm(to * from.conjugate());
    for (int step = 1; step < kSteps; ++step)
        vector = geometry::logarithm_near(geometry::exponential(way * step / kSteps) * from, vector);
    return geometry::logarithm_near(to, vector);
}

class Continuation {
  public:
    Continuation(const Unknowns& unknowns, Configuration& configuration)
        : unknowns_(unknowns),
          configuration_(configuration),
          graph_(structure::coupling_graph(unknowns.assembly())),
          is_reached_(configuration.states.size(), false) {}

    void run() {
        for (int node = 0; node < graph_.nodes; ++node)
            if (has_known_vector(node)) reach(node);
        spread();
        begin_one_by_one([this](int node) { return has_support(node); });
        begin_one_by_one([](int) { return true; });
    }

  private:
    /// True if all of a node's rotation is held, or any of it at another value than zero: other vectors would
    /// leave the held values.
    [[nodiscard]] bool has_known_vector(int node) const {
        if (!unknowns_.has_held_rotation(node)) return false;
        return (unknowns_.is_held(node, 3) && unknowns_.is_held(node, 4) && unknowns_.is_held(node, 5)) ||
               !unknowns_.constraints().values.row(node).tail<3>().isZero(0.0);
    }
    [[nodiscard]] bool has_support(int node) const {
        return std::ranges::any_of(std::views::iota(0, kDofsPerNode),
                                   [&](int dof) { return unknowns_.is_held(node, dof); });
    }

    /// Begin at one node of each part of the structure that is not reached.
    template <typename Condition>
    void begin_one_by_one(const Condition& condition) {
        for (int node = 0; node < graph_.nodes; ++node) {
            if (is_reached_[at(node)] || !condition(node)) continue;
            vector(node) = geometry::logarithm(rotation(node));
            reach(node);
            spread();
        }
    }

    void reach(int node) {
        is_reached_[at(node)] = true;
        front_.push_back(node);
    }

    /// Continue from all nodes of the front to the nodes that are not reached, nearest nodes first.
    void spread() {
        while (!front_.empty()) {
            for (const int from : std::exchange(front_, {})) spread_from(from);
        }
    }

    void spread_from(int from) {
        for (int k = graph_.start[at(from)]; k < graph_.start[at(from + 1)]; ++k) {
            const int node = graph_.neighbour[at(k)];
            if (is_reached_[at(node)]) continue;
            vector(node) = continued(rotation(from), vector(from), rotation(node));
            reach(node);
        }
    }

    Eigen::Vector3d& vector(int node) { return configuration_.rotation_vectors[at(node)]; }
    [[nodiscard]] const Eigen::Quaterniond& rotation(int node) const {
        return configuration_.states[at(node)].rotation;
    }

    const Unknowns& unknowns_;
    Configuration& configuration_;
    sparse::NodeGraph graph_;
    std::vector<bool> is_reached_;
    std::vector<int> front_;  ///< nodes reached last
};

}  // namespace

void continue_along_elements(const Unknowns& unknowns, Configuration& configuration) {
    Continuation(unknowns, configuration).run();
}

}  // namespace fretwork::mechanics::nonlinear

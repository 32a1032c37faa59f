// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/search/closest_point.hpp>
#include <fretwork/design/target/target.hpp>
#include <fretwork/mechanics/frame/frame.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <Eigen/Core>

#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace fretwork::design::detail {

/// A linear function of one node's displacement and rotation vector, and its distance from the wanted value.
struct Observation {
    Eigen::Index node = 0;
    Eigen::Matrix<double, 6, 1> direction = Eigen::Matrix<double, 6, 1>::Zero();
    double residual = 0.0;  ///< m: its value minus the wanted value
    double weight = 1.0;    ///< weight of the squared residual
};

/// The goals of a target under one load case, for the nodes of a tessellation. A rotation counts as the
/// displacement that it causes at a distance of one mean tile side.
class CaseGoals {
  public:
    /// Throws InputError that names the goal ("/goals/3") and its error: nodes or load cases that are not
    /// there, displacements far beyond the surface's size, goals that contradict each other.
    CaseGoals(const Target& target, const std::string& load_case, const std::string& default_case,
              const tiling::Tessellation& tessellation);

    [[nodiscard]] bool empty() const { return goals_.empty(); }
    /// The observation of every component that is not free, in a fixed order.
    /// @param aim  added to the wanted positions in space, a row for each node; may be empty
    [[nodiscard]] std::vector<Observation> observe(const mechanics::NodeValues& displacements,
                                                   const mechanics::NodeValues& aim) const;
    /// The distance of each node of each goal, m.
    [[nodiscard]] std::vector<double> distances(const mechanics::NodeValues& displacements) const;
    /// The largest wanted displacement, m.
    [[nodiscard]] double largest() const { return largest_; }
    [[nodiscard]] std::size_t node_count() const { return goals_.size(); }
    /// True if nodes may slide along a surface.
    [[nodiscard]] bool slides() const;
    /// One line for each goal that wants nodes elsewhere than `held` holds them.
    [[nodiscard]] std::vector<std::string> against(const simulation::Conditions& held) const;
    /// Each node that has a place to go to, where that is (m), and its distance (m).
    struct Place {
        Eigen::Index node = 0;
        Eigen::Vector3d wanted = Eigen::Vector3d::Zero();  ///< free components are as they are
        double distance = 0.0;
    };
    [[nodiscard]] std::vector<Place> places(const mechanics::NodeValues& displacements) const;
    /// The sum of weighted squares of what is wanted (m^2), of what is there, and of their products: a
    /// multiple t of the displacements misses by wanted - 2 t both + t^2 there.
    struct Products {
        double wanted = 0.0;
        double both = 0.0;
        double there = 0.0;
    };
    [[nodiscard]] Products products(const mechanics::NodeValues& displacements) const;

  private:
    struct Components {
        FreeVector wanted;
        bool is_rotation = false;
    };
    /// The goal of one node.
    struct NodeWish {
        Eigen::Index node = 0;
        Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< at rest
        std::variant<Components, std::shared_ptr<const SpaceMesh>> what;
        double weight = 1.0;
        std::size_t goal = 0;  ///< its place in the target
    };
    void add(const Goal& goal, const tiling::Tessellation& tessellation);
    /// Throws InputError if two goals want one component of a node to be different.
    void require_agreement() const;
    void add_nodes(const Goal& goal, const tiling::Tessellation& tessellation);
    void observe(const NodeWish& wish, const mechanics::NodeValues& displacements, const Eigen::Vector3d& aim,
                 std::vector<Observation>& list) const;

    std::vector<NodeWish> goals_;
    double length_ = 0.0;  ///< m, the distance at which rotations count
    double largest_ = 0.0;
};

}  // namespace fretwork::design::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/design_warning.hpp>
#include <fretwork/design/goals/space_mesh.hpp>
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

/// A linear function of one node's displacement and rotation vector, and its difference from the wanted
/// value.
struct Observation {
    Eigen::Index node = 0;
    Eigen::Matrix<double, 6, 1> direction = Eigen::Matrix<double, 6, 1>::Zero();
    double residual = 0.0;  ///< value minus wanted value, m
    double weight = 1.0;    ///< weight of the squared residual
};

/// The goals of a target under one load case, for the nodes of a tessellation. A rotation counts as the
/// displacement that it causes at a distance of one mean tile side.
class CaseGoals {
  public:
    /// Collect the goals under a load case. Throws InputError that names an invalid goal ("/goals/3") and its
    /// error: nodes that do not exist, invalid expressions and meshes, displacements of more than ten times
    /// the surface's size, goals that contradict each other, or as Goal::validate().
    /// @param default_case  the load case of goals that name none
    CaseGoals(const Target& target, const std::string& load_case, const std::string& default_case,
              const tiling::Tessellation& tessellation);

    [[nodiscard]] bool empty() const { return goals_.empty(); }
    /// One observation for each component that is not free, and one for each node on a mesh, in a fixed
    /// order.
    /// @param aim  displacements that are added to the wanted positions, one row for each node; may be empty
    [[nodiscard]] std::vector<Observation> observe(const mechanics::NodeValues& displacements,
                                                   const mechanics::NodeValues& aim) const;
    /// The distance of each node of each goal from its wanted position, m.
    [[nodiscard]] std::vector<double> distances(const mechanics::NodeValues& displacements) const;
    /// The largest wanted displacement, m.
    [[nodiscard]] double largest() const { return largest_; }
    [[nodiscard]] std::size_t node_count() const { return goals_.size(); }
    /// True if nodes may slide along the mesh of a goal.
    [[nodiscard]] bool slides() const;
    /// A warning about each goal that contradicts the components held by `held`.
    [[nodiscard]] std::vector<DesignWarning> against(const simulation::Conditions& held) const;
    /// A node with a wanted position.
    struct Place {
        Eigen::Index node = 0;
        /// Wanted position, m; free components equal those of the present position.
        Eigen::Vector3d wanted = Eigen::Vector3d::Zero();
        double distance = 0.0;  ///< m
    };
    [[nodiscard]] std::vector<Place> places(const mechanics::NodeValues& displacements) const;
    /// Three weighted sums over the observations, m^2: of squared wanted values (`wanted`), of squared
    /// present values (`there`), and of the products of both (`both`). For displacements multiplied by t, the
    /// weighted sum of squared residuals is wanted - 2 t both + t^2 there; with meshes, nearly so.
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
    struct NodeGoal {
        Eigen::Index node = 0;
        Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< position at rest, m
        std::variant<Components, std::shared_ptr<const SpaceMesh>> what;
        double weight = 1.0;
        std::size_t goal = 0;  ///< index of the goal in the target
    };
    void add(const Goal& goal, const tiling::Tessellation& tessellation);
    /// Check that no two goals want different values of one component of a node. Throws InputError.
    void require_agreement() const;
    void add_nodes(const Goal& goal, const tiling::Tessellation& tessellation);
    void observe(const NodeGoal& wish, const mechanics::NodeValues& displacements, const Eigen::Vector3d& aim,
                 std::vector<Observation>& list) const;

    std::vector<NodeGoal> goals_;
    double length_ = 0.0;  ///< distance that turns rotations into displacements, m
    double largest_ = 0.0;
};

}  // namespace fretwork::design::detail

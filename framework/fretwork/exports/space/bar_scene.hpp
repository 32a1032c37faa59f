// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/scene.hpp>

#include <Eigen/Core>

#include <array>
#include <span>
#include <string>
#include <vector>

namespace fretwork::exports {

/// A surface as bars with their real section in space, at rest and deformed by one result, for views in 3D.
/// Lengths are in metres.
struct BarScene {
    std::vector<Eigen::Vector3d> nodes;  ///< positions at rest
    mechanics::NodeValues motion;  ///< a row for each node: displacement and rotation vector; zero at rest
    std::vector<std::array<int, 2>> bars;  ///< pairs of nodes
    std::vector<int> patterns;             ///< index of the pattern of each bar
    double width = 0.0;   ///< width of the bars in the plane: that of the rectangle with the section's area
                          ///< and second moments
    double height = 0.0;  ///< height of this rectangle, out of the plane

    /// A field: a value at both ends of each bar, SI.
    struct Field {
        std::string name;            ///< "displacement", "stress", ..
        std::string title;           ///< for people
        std::string unit;            ///< unit of `factor` times the value
        double factor = 1.0;         ///< from SI to the unit that is shown
        std::vector<double> values;  ///< NaN if a value is not known
    };
    std::vector<Field> fields;  ///< quantities over the bars

    /// A node that is held.
    struct Support {
        int node = 0;  ///< which node
        enum class Kind { Clamped, Pinned, Other } kind = Kind::Other;
    };
    std::vector<Support> supports;  ///< of the load case
    /// The sum of all loads on a node, its share of the weight included.
    struct Load {
        int node = 0;                                      ///< which node
        Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N
        Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< N m
    };
    std::vector<Load> loads;                                   ///< of the load case
    std::string title;                                         ///< "92 tiles, full, bridge"
    reduction::Joints joints = reduction::Joints::Centreline;  ///< joints of the surface's setting
};

/// The bars of a scene, with the motions of its first result. Inner nodes of condensed tiles are recovered. A
/// tile is drawn as the closed line through its interface nodes if its model does not give the motions of its
/// beams. Throws InputError if the result belongs to another surface.
BarScene make_bar_scene(const Scene& scene);

/// The name of the field of utilizations, which exists if a strength is known.
inline constexpr const char* kUtilization = "utilization";

/// The names of the fields that a scene with a result has.
std::vector<std::string> bar_field_names();

/// The position of a node with `scale` times its displacement.
Eigen::Vector3d place_of(const BarScene& scene, int node, double scale);

}  // namespace fretwork::exports

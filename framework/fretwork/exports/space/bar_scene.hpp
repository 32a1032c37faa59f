// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/scene.hpp>

#include <Eigen/Core>

#include <array>
#include <span>
#include <string>
#include <vector>

namespace fretwork::exports {

/// A surface as bars with their real section in space, at rest and deformed by a result, for views in 3D.
/// Lengths are in metres.
struct BarScene {
    std::vector<Eigen::Vector3d> nodes;  ///< positions of the nodes at rest
    /// Displacement and rotation vector of each node, one row for each; zero without a result.
    mechanics::NodeValues motion;
    std::vector<std::array<int, 2>> bars;  ///< the two nodes of each bar
    std::vector<int> patterns;             ///< index of the pattern of each bar
    /// Width of the bars in the plane, from the rectangle with the section's area and second moments.
    double width = 0.0;
    double height = 0.0;  ///< height of the bars out of the plane, from the same rectangle

    /// A field: the value of a quantity at both ends of each bar, SI.
    struct Field {
        std::string name;            ///< name: "displacement", "stress", ..
        std::string title;           ///< title for people
        std::string unit;            ///< unit that is shown
        double factor = 1.0;         ///< factor from SI to the unit that is shown
        std::vector<double> values;  ///< values, two for each bar; NaN: not known
    };
    std::vector<Field> fields;  ///< quantities over the bars

    /// The support of a node.
    struct Support {
        int node = 0;  ///< the node
        /// The kind of support.
        enum class Kind {
            Clamped,  ///< all components are fixed
            Pinned,   ///< all displacements are fixed, and no rotation
            Other     ///< any other set of components is fixed
        };
        Kind kind = Kind::Other;  ///< kind of the support
    };
    std::vector<Support> supports;  ///< supports of the load case
    /// The sum of all loads on a node, with the node's share of the weight.
    struct Load {
        int node = 0;                                      ///< the node
        Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N
        Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< N m
    };
    std::vector<Load> loads;                                   ///< loads of the load case
    std::string title;                                         ///< title, such as "92 tiles, full, bridge"
    reduction::Joints joints = reduction::Joints::Centreline;  ///< joints of the surface's setting
};

/// Make the bars of a scene, with the motions of the scene's first result. Inner nodes of condensed tiles are
/// recovered. A tile is drawn as the closed line through its interface nodes if its model does not give the
/// motions of its beams. Throws InputError if the result belongs to another surface.
BarScene make_bar_scene(const Scene& scene);

/// The name of the field of utilizations, which a bar scene has if a strength is known.
inline constexpr const char* kUtilization = "utilization";

/// The names of the fields of a bar scene with a result.
std::vector<std::string> bar_field_names();

/// The position of a node with `scale` times its displacement.
Eigen::Vector3d place_of(const BarScene& scene, int node, double scale);

}  // namespace fretwork::exports

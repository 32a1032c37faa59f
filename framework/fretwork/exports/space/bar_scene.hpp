// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/scene.hpp>

#include <Eigen/Core>

#include <array>
#include <span>
#include <string>
#include <vector>

namespace fretwork::exports {

/// A surface as bars in space, at rest and deformed by a result, for 3D views. Lengths are in metres.
struct BarScene {
    std::vector<Eigen::Vector3d> nodes;  ///< positions of the nodes at rest
    /// Displacement and rotation vector of each node, one row for each node. Zero without a result, and where
    /// the result does not give it.
    mechanics::NodeValues motion;
    std::vector<std::array<int, 2>> bars;  ///< the two nodes of each bar
    std::vector<int> patterns;             ///< index of the pattern of each bar
    double width = 0.0;                    ///< width of the bars in the plane
    double height = 0.0;                   ///< height of the bars out of the plane

    /// A field: the values of a quantity at both ends of each bar, SI.
    struct Field {
        std::string name;            ///< name: "displacement", "stress", ..
        std::string title;           ///< title in the view
        std::string unit;            ///< unit in the view
        double factor = 1.0;         ///< factor from SI to `unit`
        std::vector<double> values;  ///< two values for each bar; NaN: unknown
    };
    std::vector<Field> fields;  ///< quantities over the bars

    /// The support of a node.
    struct Support {
        int node = 0;  ///< the node
        /// The kind of support.
        enum class Kind {
            Clamped,  ///< all components are fixed
            Pinned,   ///< all displacements and no rotations are fixed
            Other     ///< any other set of components is fixed
        };
        Kind kind = Kind::Other;  ///< kind of the support
    };
    std::vector<Support> supports;  ///< supports of the load case
    /// The sum of all loads on a node, including its share of the weight.
    struct Load {
        int node = 0;                                      ///< the node
        Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N
        Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< N m
    };
    std::vector<Load> loads;                                   ///< loads of the load case
    std::string title;                                         ///< title, such as "92 tiles, full, bridge"
    reduction::Joints joints = reduction::Joints::Centreline;  ///< joints of the surface's setting
};

/// Make the bars of a scene, deformed by the scene's first result. Inner nodes of condensed tiles are
/// recovered. If a tile's model does not give the motions of beams, the tile becomes a closed line through
/// its interface nodes. Throws InputError if the result belongs to another surface.
BarScene make_bar_scene(const Scene& scene);

/// The name of the utilization field. A bar scene has this field if it has a result and the strength is
/// known.
inline constexpr const char* kUtilization = "utilization";

/// The names of all fields that a bar scene with a result may have.
std::vector<std::string> bar_field_names();

/// The position of a node with `scale` times its displacement.
Eigen::Vector3d place_of(const BarScene& scene, int node, double scale);

}  // namespace fretwork::exports

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::reduction {

/// A standard load case of one tile in the setting's regular polygon (paper, Section 5.2 and Fig. 10). It
/// refers to one interface node on each side; spread_over_sides() adapts it to layouts with several.
struct Scenario {
    /// The support of a node.
    struct Support {
        int interface_node = 0;   ///< number of the interface node, from 0
        mechanics::DofSet fixed;  ///< components that stay zero
        friend bool operator==(const Support&, const Support&) = default;
    };
    /// A load on a node.
    struct Load {  ///< The values are for a magnitude of 1 N.
        int interface_node = 0;
        std::array<double, 3> force{};   ///< force, N
        std::array<double, 3> moment{};  ///< moment of fixed direction in space, N m
        friend bool operator==(const Load&, const Load&) = default;
    };
    std::string name;               ///< name in files and tables
    std::string description;        ///< description in one sentence
    double weight = 1.0;            ///< w_k of Eq. (8), Table 2
    double max_magnitude = 0.0;     ///< N
    std::vector<Support> supports;  ///< supports; the key "held" in files
    std::vector<Load> loads;        ///< loads at a magnitude of 1 N
    friend bool operator==(const Scenario&, const Scenario&) = default;
};

/// The five scenarios of the paper, in the paper's order: axial, shear, bending, dome, saddle
/// (experiments/scenarios/*.json).
const std::vector<Scenario>& paper_scenarios();

/// The largest number of an interface node of a scenario, more than any polygon of a setting has.
inline constexpr int kLargestInterfaceNode = 999;
/// The largest number of interface nodes on each side of a tile, more than any layout has.
inline constexpr int kMostNodesASide = 1000;

/// The scenario for a tile with several interface nodes on each side. All nodes of side i have the supports
/// of interface node i of the given scenario, and share the force and moment of that node equally. Nodes lie
/// symmetrically about the middle of their side, so the resultants of a side stay the same. The paper has one
/// node on each side. Throws InputError unless there are 1 to kMostNodesASide nodes on each side, and the
/// interface nodes of the given scenario have numbers from 0 to kLargestInterfaceNode.
Scenario spread_over_sides(const Scenario& scenario, int nodes_a_side);

/// Read a scenario from JSON text; `source` names the text in messages. Throws InputError.
Scenario parse_scenario(std::string_view text, std::string source);
/// The scenario as JSON text; parse_scenario() gives an equal scenario.
std::string scenario_text(const Scenario& scenario);
/// Read a scenario file. Throws InputError with file and JSON pointer.
Scenario read_scenario(const std::filesystem::path& path);
/// Write a scenario file atomically. Throws IoError and leaves the file as it was.
void write_scenario(const Scenario& scenario, const std::filesystem::path& path);

}  // namespace fretwork::reduction

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/simulation/load_cases/load_case.hpp>
#include <fretwork/simulation/surface.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace fretwork::simulation {

/// A load case on a surface: the supports and loads of its interface nodes. They are the same for every
/// model.
struct Conditions {
    std::vector<mechanics::Support> supports;                   ///< components that stay zero
    std::vector<mechanics::PrescribedDisplacement> prescribed;  ///< components with given values
    std::vector<mechanics::NodalLoad> loads;  ///< loads of the load case, then the shares of the tiles'
                                              ///< weight
    std::size_t weights = 0;                  ///< number of entries of `loads` that are shares of the weight
};

/// Apply a load case to the nodes of a surface. Throws InputError as check_selections(), if two entries
/// prescribe different values of one component, if the load case combines others (combined() merges them), or
/// if gravity acts on beams without density or on unpainted tiles.
Conditions resolve(const LoadCase& load_case, const Surface& surface);
/// Apply a load case to the nodes of a surface. `tile_masses` has the masses of all tiles, kg, and may be
/// empty if needs_masses() is false. Throws as above, but not because of unpainted tiles.
Conditions resolve(const LoadCase& load_case, const Surface& surface, std::span<const double> tile_masses);
/// True if the load case has gravity and the surface has mass.
bool needs_masses(const LoadCase& load_case, const Surface& surface);

/// The loads (N, N m), one row for each of `nodes` nodes; interface nodes come first.
mechanics::NodeValues load_rows(const Conditions& conditions, std::size_t nodes);

/// Apply conditions to an assembly: add the supports, and replace prescribed displacements and loads. The
/// interface nodes are the first nodes of the assembly.
void apply(const Conditions& conditions, mechanics::Assembly& assembly);

/// The nodes that the entries of a load case select, and the loads on these nodes. Each list is in the order
/// in which load_case_text() writes the entries.
struct EntryMarks {
    /// The nodes of a load, and each node's share of the load's vectors.
    struct Load {
        std::vector<tiling::InterfaceIndex> nodes;  ///< loaded nodes, ascending
        std::vector<double> shares;                 ///< shares of `force` and `moment`; 1 if each node bears
                                                    ///< the whole load
        Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N
        Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< N m
        /// Loaded area (m2) for a load per area, loaded length (m) for a load per length, 0 for other loads.
        double extent = 0.0;
    };
    std::vector<std::vector<tiling::InterfaceIndex>> supports;  ///< nodes of each entry
    /// Loads of each entry; loads per area come last.
    std::vector<Load> loads;
    std::vector<std::vector<tiling::InterfaceIndex>> prescribed;  ///< nodes of each entry
};

/// The marks of a load case's entries, without gravity and without combined load cases. Throws InputError as
/// check_selections().
EntryMarks entry_marks(const LoadCase& load_case, const tiling::Tessellation& tessellation);

/// Check that every entry of a load case has its place on a tessellation, painted or not: interface nodes,
/// tiles, or a line along the rim. Throws InputError that names the load case and the entry, by its position
/// in the file from which it was read, or else in load_case_text().
void check_selections(const LoadCase& load_case, const tiling::Tessellation& tessellation);

}  // namespace fretwork::simulation

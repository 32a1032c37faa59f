// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/simulation/load_cases/load_case.hpp>
#include <fretwork/simulation/surface.hpp>

#include <span>
#include <vector>

namespace fretwork::simulation {

/// A load case on a surface: which interface nodes are held, and what acts on each; the same for every model.
struct Conditions {
    std::vector<mechanics::Support> supports;
    std::vector<mechanics::PrescribedDisplacement> prescribed;
    std::vector<mechanics::NodalLoad> loads;  ///< of the load case, then the shares of the tiles' weight
};

/// Throws InputError that names the entry of the load case that picks no node, and for gravity on beams that
/// have no density.
Conditions resolve(const LoadCase& load_case, const Surface& surface);
/// The same with the masses of all tiles known already, kg. Empty where needs_masses() says no.
Conditions resolve(const LoadCase& load_case, const Surface& surface, std::span<const double> tile_masses);
/// Whether there is gravity in the load case, and mass for it to act on.
bool needs_masses(const LoadCase& load_case, const Surface& surface);

/// The loads as one row for each of `nodes` nodes, of which the first are the interface nodes.
mechanics::NodeValues load_rows(const Conditions& conditions, std::size_t nodes);

/// Hold and load an assembly whose first nodes are the interface nodes: supports are added, prescribed
/// displacements and loads take the place of those that it had.
void apply(const Conditions& conditions, mechanics::Assembly& assembly);

/// The nodes that the entries of a load case pick, and their loads, each list in the order of its entries in
/// a file.
struct EntryMarks {
    /// The nodes of a load, and how much of its vectors each of them bears.
    struct Load {
        std::vector<tiling::InterfaceIndex> nodes;  ///< ascending
        std::vector<double> shares;                 ///< of `force` and `moment`; 1 where each node bears all
        Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N
        Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< N m
        double extent = 0.0;  ///< m2 of a load per area, m of one per length; 0 of others
    };
    std::vector<std::vector<tiling::InterfaceIndex>> supports;
    std::vector<Load> loads;  ///< those on areas are the last
    std::vector<std::vector<tiling::InterfaceIndex>> prescribed;
};

/// The entries of one load case, without gravity and without the load cases that it combines. Throws
/// InputError as check_selections does.
EntryMarks entry_marks(const LoadCase& load_case, const tiling::Tessellation& tessellation);

/// Check that every entry of a load case picks interface nodes of a tessellation, painted or not. Throws
/// InputError that names the load case and the entry.
void check_selections(const LoadCase& load_case, const tiling::Tessellation& tessellation);

}  // namespace fretwork::simulation

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/results/section_forces.hpp>
#include <fretwork/simulation/results/surface_result.hpp>
#include <fretwork/simulation/session.hpp>
#include <fretwork/simulation/surface.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fretwork::simulation {

/// The forces and stresses of one beam of a surface. No loads act between the ends of a beam, so the largest
/// stress is at one of its ends.
struct BeamRow {
    std::size_t beam = 0;    ///< index of the beam in the full model
    tiling::TileIndex tile;  ///< tile of the beam
    /// Indices of the ends in the full model, where interface nodes come first.
    std::array<int, 2> nodes{};
    std::array<Eigen::Vector3d, 2> places{};           ///< positions of the ends at rest, m
    std::array<mechanics::SectionForces, 2> forces{};  ///< section forces at both ends
    std::array<double, 2> stress{};                    ///< largest normal stress at each end, Pa
    std::array<double, 2> von_mises{};                 ///< largest von Mises stress at each end, Pa
    /// The largest normal stress of both ends, Pa.
    [[nodiscard]] double largest_stress() const { return std::max(stress[0], stress[1]); }
    /// The largest von Mises stress of both ends, Pa.
    [[nodiscard]] double largest_von_mises() const { return std::max(von_mises[0], von_mises[1]); }
};

/// The beams of a surface in a result.
struct BeamTable {
    std::vector<BeamRow> rows;         ///< beams in tiles with a tile model that gives their motions
    std::size_t unknown = 0;           ///< number of beams in other tiles
    std::optional<double> strength{};  ///< strength behind the utilizations, Pa
    reduction::Joints joints{};        ///< joints of the setting
    mechanics::SectionShape shape{};   ///< shape of the section behind the stresses
    /// False: `shape` is the rectangle with the section's radii of gyration.
    bool is_shape_given = false;
    /// The utilization of a beam: the largest von Mises stress divided by the strength. None if the strength
    /// is not known.
    [[nodiscard]] std::optional<double> utilization(const BeamRow& row) const;
};

/// The table of a result, with the strength of the setting's material, if the setting has one. Throws
/// InputError as beam_state() of a result; Stopped.
BeamTable beam_table(const Surface& surface, const SurfaceResult& result,
                     std::span<const reduction::TileModel> models = reduction::tile_models(),
                     const base::Control& control = {});

/// The tables of a result at the end of each of its load steps or stages, one for each of Result::load_steps.
/// Throws as beam_table().
std::vector<BeamTable> step_beam_tables(
    const Surface& surface, const SurfaceResult& result,
    std::span<const reduction::TileModel> models = reduction::tile_models(),
    const base::Control& control = {});

/// The table of a solution since the session's last edit. Throws InputError as
/// Session::require_since_edit(); Stopped.
BeamTable beam_table(const Session& session, const mechanics::Solution& solution,
                     const base::Control& control = {});

/// The `count` rows with the largest von Mises stresses, largest first; fewer if the table has fewer rows.
std::vector<BeamRow> most_stressed(const BeamTable& table, std::size_t count);

/// The formula of the utilizations, in one line.
std::string utilization_formula(const BeamTable& table);

/// The table as CSV with LF, in SI: beam, tile, pattern, nodes, places (x and y), length, section forces and
/// stresses at both ends, the largest stresses, and the utilization (empty without strength).
std::string beam_table_csv(const BeamTable& table, const Surface& surface);
/// The table as JSON: `{"format", "joints", "strength", "utilization_formula", "unknown_beams",
/// "beams": [..]}`. Throws NumericalError if a value is not finite.
std::string beam_table_json(const BeamTable& table, const Surface& surface);

}  // namespace fretwork::simulation

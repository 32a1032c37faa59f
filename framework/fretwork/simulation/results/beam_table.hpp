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

/// Forces and stresses of one beam of a surface. No loads act between its ends, so the largest stress is at
/// one of them.
struct BeamRow {
    std::size_t beam = 0;                     ///< its index in the full model
    tiling::TileIndex tile;                   ///< whose beam it is
    std::array<int, 2> nodes{};               ///< indices in the full model; interface nodes come first
    std::array<Eigen::Vector3d, 2> places{};  ///< positions of its ends at rest, m
    std::array<mechanics::SectionForces, 2> forces{};  ///< at both ends
    std::array<double, 2> stress{};                    ///< Pa, the largest normal stress at each end
    std::array<double, 2> von_mises{};                 ///< Pa, the largest von Mises stress at each end
    /// Pa, normal, of both ends.
    [[nodiscard]] double largest_stress() const { return std::max(stress[0], stress[1]); }
    /// Pa, of both ends.
    [[nodiscard]] double largest_von_mises() const { return std::max(von_mises[0], von_mises[1]); }
};

/// The beams of a surface in a result.
struct BeamTable {
    std::vector<BeamRow> rows;         ///< the beams whose tile model gives their motions
    std::size_t unknown = 0;           ///< number of beams of other tiles
    std::optional<double> strength{};  ///< Pa, the reference of utilizations
    reduction::Joints joints{};        ///< of the setting, in whose beams the forces act
    mechanics::SectionShape shape{};   ///< shape of the section for which stresses are computed
    bool is_shape_given =
        false;  ///< else `shape` is the rectangle with the section's area and second moments
    /// The utilization of a beam: the largest von Mises stress divided by the strength. None without a
    /// strength.
    [[nodiscard]] std::optional<double> utilization(const BeamRow& row) const;
};

/// The table of a result, with the strength of the setting's material, if it has one. Throws InputError if
/// the result does not belong to the surface, or one of its models is not in `models`.
BeamTable beam_table(const Surface& surface, const SurfaceResult& result,
                     std::span<const reduction::TileModel> models = reduction::tile_models());

/// The table of a solution that the session gave since its last edit.
BeamTable beam_table(const Session& session, const mechanics::Solution& solution);

/// The rows with the largest von Mises stress first; `count` of them at most.
std::vector<BeamRow> most_stressed(const BeamTable& table, std::size_t count);

/// The formula of the utilizations, in one line.
std::string utilization_formula(const BeamTable& table);

/// The table as CSV with LF, in SI: beam, tile, pattern, nodes, places, and section forces and stresses at
/// both ends.
std::string beam_table_csv(const BeamTable& table, const Surface& surface);
/// The same as JSON: `{"joints", "strength", "utilization_formula", "unknown_beams", "beams": [..]}`.
std::string beam_table_json(const BeamTable& table, const Surface& surface);

}  // namespace fretwork::simulation

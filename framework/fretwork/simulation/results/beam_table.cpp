// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/mechanics/internal/node_json.hpp>
#include <fretwork/simulation/results/beam_table.hpp>
#include <fretwork/simulation/results/surface_beams.hpp>

#include <algorithm>
#include <cmath>

namespace fretwork::simulation {
namespace {

using base::format_number;
using mechanics::SectionForces;

std::string pattern_of(const BeamRow& row, const Surface& surface) {
    const pattern::NamedPattern* pattern = tiling::pattern_of(surface.tessellation, row.tile);
    return pattern == nullptr ? "" : pattern->id;
}

double length_of(const BeamRow& row) {
    return (row.places[1] - row.places[0]).norm();
}

base::Json end_json(const BeamRow& row, std::size_t end) {
    const SectionForces& f = row.forces[end];
    return {{"node", row.nodes[end]},
            {"place", mechanics::vector_json(row.places[end])},
            {"N", f.N},
            {"V2", f.V2},
            {"V3", f.V3},
            {"T", f.T},
            {"M2", f.M2},
            {"M3", f.M3},
            {"stress", row.stress[end]},
            {"von_mises", row.von_mises[end]}};
}

BeamTable table_of(const Surface& surface, const SurfaceBeams& beams, const BeamState& state) {
    BeamTable table;
    table.strength = surface.setting.strength;
    table.joints = surface.setting.joints;
    table.shape = mechanics::shape_of(surface.setting.section);
    table.is_shape_given = surface.setting.section.shape.has_value();
    for (std::size_t b = 0; b < beams.ends.size(); ++b) {
        BeamRow row{.beam = b, .tile = beams.tiles[b]};
        for (std::size_t end = 0; end < 2; ++end) {
            const auto f = state.forces.row(static_cast<Eigen::Index>(2 * b + end));
            const auto node = beams.ends[b][end];
            row.nodes[end] = node.value;
            row.places[end] = beams.nodes[node];
            row.forces[end] = {f[0], f[1], f[2], f[3], f[4], f[5]};
            row.stress[end] = f[kStressField];
            row.von_mises[end] = f[kVonMisesField];
        }
        if (std::isnan(row.stress[0]) || std::isnan(row.stress[1]))
            ++table.unknown;
        else
            table.rows.push_back(row);
    }
    return table;
}

}  // namespace

std::optional<double> BeamTable::utilization(const BeamRow& row) const {
    if (!strength) return std::nullopt;
    return row.largest_von_mises() / *strength;
}

BeamTable beam_table(const Surface& surface, const SurfaceResult& result,
                     std::span<const reduction::TileModel> models, const base::Control& control) {
    const SurfaceBeams beams = surface_beams(surface);
    return table_of(
        surface, beams,
        beam_state(surface, result, beams, beam_sections(beams, surface.setting), models, control));
}

std::vector<BeamTable> step_beam_tables(const Surface& surface, const SurfaceResult& result,
                                        std::span<const reduction::TileModel> models,
                                        const base::Control& control) {
    const SurfaceBeams beams = surface_beams(surface);
    std::vector<BeamTable> tables;
    for (const BeamState& state :
         step_beam_states(surface, result, beams, beam_sections(beams, surface.setting), models, control))
        tables.push_back(table_of(surface, beams, state));
    return tables;
}

BeamTable beam_table(const Session& session, const mechanics::Solution& solution,
                     const base::Control& control) {
    const Surface& surface = session.surface();
    const SurfaceBeams beams = surface_beams(surface);
    return table_of(surface, beams,
                    beam_state(session, solution, beams, beam_sections(beams, surface.setting), control));
}

std::vector<BeamRow> most_stressed(const BeamTable& table, std::size_t count) {
    std::vector<BeamRow> rows = table.rows;
    std::ranges::stable_sort(rows, std::ranges::greater{}, &BeamRow::largest_von_mises);
    rows.resize(std::min(rows.size(), count));
    return rows;
}

std::string utilization_formula(const BeamTable& table) {
    return std::string(
               "largest von Mises stress of bending, axial force, shear and torsion over the strength; "
               "section: ") +
           mechanics::shape_name(table.shape) + (table.is_shape_given ? "" : " with its radii of gyration");
}

std::string beam_table_csv(const BeamTable& table, const Surface& surface) {
    std::string text = "beam,tile,pattern,node_a,node_b,xa_m,ya_m,xb_m,yb_m,length_m";
    for (const char* end : {"a", "b"}) {
        for (const char* name : {"N", "V2", "V3"}) text += std::string(",") + name + end + "_N";
        for (const char* name : {"T", "M2", "M3"}) text += std::string(",") + name + end + "_Nm";
        text += std::string(",stress_") + end + "_Pa,von_mises_" + end + "_Pa";
    }
    text += ",largest_stress_Pa,largest_von_mises_Pa,utilization\n";
    for (const BeamRow& row : table.rows) {
        text += std::to_string(row.beam) + "," + std::to_string(row.tile.value) + "," +
                pattern_of(row, surface) + "," + std::to_string(row.nodes[0]) + "," +
                std::to_string(row.nodes[1]);
        for (const Eigen::Vector3d& place : row.places)
            text += "," + format_number(place.x()) + "," + format_number(place.y());
        text += "," + format_number(length_of(row));
        for (std::size_t end = 0; end < 2; ++end) {
            const SectionForces& f = row.forces[end];
            for (const double value : {f.N, f.V2, f.V3, f.T, f.M2, f.M3, row.stress[end], row.von_mises[end]})
                text += "," + format_number(value);
        }
        const auto utilization = table.utilization(row);
        text += "," + format_number(row.largest_stress()) + "," + format_number(row.largest_von_mises()) +
                "," + (utilization ? format_number(*utilization) : "") + "\n";
    }
    return text;
}

std::string beam_table_json(const BeamTable& table, const Surface& surface) {
    base::Json rows = base::Json::array();
    for (const BeamRow& row : table.rows) {
        rows.push_back({{"beam", row.beam},
                        {"tile", row.tile.value},
                        {"pattern", pattern_of(row, surface)},
                        {"length", length_of(row)},
                        {"ends", {end_json(row, 0), end_json(row, 1)}},
                        {"largest_stress", row.largest_stress()},
                        {"largest_von_mises", row.largest_von_mises()},
                        {"utilization", base::or_null(table.utilization(row))}});
    }
    return base::json_text({{"format", "fretwork/beams/2"},
                            {"joints", reduction::joints_name(table.joints)},
                            {"strength", base::or_null(table.strength)},
                            {"utilization_formula", utilization_formula(table)},
                            {"unknown_beams", table.unknown},
                            {"beams", std::move(rows)}});
}

}  // namespace fretwork::simulation

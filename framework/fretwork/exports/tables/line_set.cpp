// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/exports/tables/line_set.hpp>
#include <fretwork/reduction/calibration/model_response.hpp>
#include <fretwork/simulation/results/surface_beams.hpp>

#include <cmath>
#include <cstdio>
#include <numbers>

namespace fretwork::exports {
namespace {

using simulation::Surface;

/// Each tile as the closed line through its interface nodes.
LineSet tile_loops(const Surface& surface) {
    LineSet set;
    for (const geometry::Point2& node : surface.tessellation.interface_nodes)
        set.nodes.emplace_back(node.x, node.y, 0.0);
    for (std::size_t t = 0; t < surface.tessellation.tiles.size(); ++t) {
        const tiling::Tile& tile = surface.tessellation.tiles[t];
        for (std::size_t k = 0; k < tile.interface_nodes.size(); ++k) {
            const auto next = tile.interface_nodes[(k + 1) % tile.interface_nodes.size()];
            set.lines.push_back({tile.interface_nodes[k].value, next.value});
            set.tiles.push_back(static_cast<int>(t));
            set.patterns.push_back(tile.pattern);
        }
    }
    return set;
}

/// The nodes of an assembly of beams between which lines are drawn: not those of hinges.
struct DrawnNodes {
    explicit DrawnNodes(const mechanics::Assembly& assembly) : place(assembly.nodes.size(), -1) {
        for (int node = 0; node < assembly.reported_nodes; ++node) add(node);
        for (const auto& element : assembly.elements) {
            for (const mechanics::NodeIndex end : element->nodes().first(2)) add(end.value);
        }
    }
    void add(int node) {
        int& own = place[node];
        if (own >= 0) return;
        own = static_cast<int>(nodes.size());
        nodes.push_back(node);
    }
    [[nodiscard]] int place_of(mechanics::NodeIndex node) const { return place[node.value]; }
    [[nodiscard]] mechanics::NodeValues rows(const mechanics::NodeValues& reported,
                                             const mechanics::NodeValues& inner) const {
        mechanics::NodeValues all(reported.rows() + inner.rows(), mechanics::kDofsPerNode);
        all << reported, inner;
        return all(nodes, Eigen::all);
    }

    std::vector<int> nodes;
    std::vector<int> place;  ///< index in `nodes` of each node of the assembly, or -1
};

/// For each beam, the end value of larger size.
std::vector<double> largest_of_ends(const simulation::BeamState& state, Eigen::Index column) {
    std::vector<double> values;
    for (Eigen::Index b = 0; 2 * b < state.forces.rows(); ++b) {
        const double from = state.forces(2 * b, column);
        const double to = state.forces(2 * b + 1, column);
        values.push_back(std::abs(from) >= std::abs(to) ? from : to);
    }
    return values;
}

void add_modes(const mechanics::Result& result, LineSet& set) {
    const auto add = [&](const char* kind, const std::vector<mechanics::Mode>& modes, const char* unit) {
        for (std::size_t i = 0; i < modes.size(); ++i) {
            if (modes[i].shape.rows() != std::ssize(set.nodes)) continue;
            char name[64];
            std::snprintf(name, sizeof name, "%s %zu, %.6g %s", kind, i + 1, modes[i].value, unit);
            set.fields.push_back({name, modes[i].shape.leftCols<3>()});
        }
    };
    add("vibration", result.vibration_modes, "Hz");
    add("buckling", result.buckling_modes, "times the load");
}

struct Wanted {
    std::optional<double> strength;
    std::span<const reduction::TileModel> models;
};

/// Replace the lines by all beams with their fields, if all motions of beams are known.
void add_beam_fields(const Surface& surface, const simulation::SurfaceResult& result, const Wanted& wanted,
                     LineSet& set) {
    const simulation::SurfaceBeams beams = simulation::surface_beams(surface);
    const auto sections = simulation::beam_sections(beams, surface.setting);
    const simulation::BeamState state =
        simulation::beam_state(surface, result, beams, sections, wanted.models);
    if (state.nodes.hasNaN()) return;
    set = surface_lines(surface);
    set.displacements = state.nodes;
    for (std::size_t column = 0; column < simulation::kBeamFields.size(); ++column)
        set.line_fields.push_back({simulation::kBeamFields[column], largest_of_ends(state, column)});
    if (wanted.strength) {
        set.line_fields.push_back({"utilization", set.line_fields.back().values});
        for (double& share : set.line_fields.back().values) share /= *wanted.strength;
    }
    add_modes(result, set);
}

}  // namespace

void require_same_surface(const Surface& surface, const simulation::SurfaceResult& result) {
    const auto& places = surface.tessellation.interface_nodes;
    const auto fail = [](const std::string& what) {
        throw base::InputError("the result is not one of this project: " + what);
    };
    if (result.nodes.size() < places.size()) fail("it has too few nodes");
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Eigen::Vector3d place(places[i].x, places[i].y, 0.0);
        if (!result.nodes[i].is_interface ||
            (result.nodes[i].rest_position - place).norm() > simulation::kSamePlace) {
            fail("its node " + std::to_string(i) + " is not the interface node of that number");
        }
    }
}

LineSet surface_lines(const Surface& surface) {
    LineSet set;
    const simulation::SurfaceBeams beams = simulation::surface_beams(surface);
    set.nodes = beams.nodes;
    for (std::size_t b = 0; b < beams.ends.size(); ++b) {
        const std::size_t tile = beams.tiles[b];
        set.lines.push_back({beams.ends[b][0].value, beams.ends[b][1].value});
        set.tiles.push_back(static_cast<int>(tile));
        set.patterns.push_back(surface.tessellation.tiles[tile].pattern);
    }
    return set;
}

LineSet result_lines(const Surface& surface, const simulation::SurfaceResult& result) {
    require_same_surface(surface, result);
    LineSet set = surface_lines(surface);
    if (!simulation::has_nodes_at(result, set.nodes)) set = tile_loops(surface);
    set.displacements = result.solution.displacements.topRows(set.nodes.size());
    return set;
}

LineSet beam_lines(const Surface& surface, const simulation::SurfaceResult* result,
                   std::optional<double> strength, std::span<const reduction::TileModel> models) {
    LineSet set = result == nullptr ? surface_lines(surface) : result_lines(surface, *result);
    if (result != nullptr) add_beam_fields(surface, *result, {strength, models}, set);
    set.pattern_names = pattern::ids_of(surface.tessellation.patterns);
    set.joints = reduction::joints_name(surface.setting.joints);
    set.line_fields.push_back(
        {"radius",
         std::vector<double>(set.lines.size(), std::sqrt(surface.setting.section.area / std::numbers::pi))});
    return set;
}

LineSet frame_lines(const mechanics::Frame& frame) {
    LineSet set;
    set.nodes = frame.nodes;
    for (const mechanics::Beam& beam : frame.beams)
        set.lines.push_back({beam.nodes[0].value, beam.nodes[1].value});
    return set;
}

LineSet solution_lines(const mechanics::Assembly& assembly, const mechanics::Result& result) {
    const DrawnNodes drawn(assembly);
    LineSet set;
    for (const int node : drawn.nodes) set.nodes.push_back(assembly.nodes[node]);
    for (const auto& element : assembly.elements) {
        const auto ends = element->nodes();
        set.lines.push_back({drawn.place_of(ends[0]), drawn.place_of(ends[1])});
    }
    const auto& solution = result.solution;
    set.displacements = drawn.rows(solution.displacements, solution.inner_displacements);
    const auto add = [&](const char* kind, const std::vector<mechanics::Mode>& modes, const char* unit) {
        for (std::size_t i = 0; i < modes.size(); ++i) {
            char name[64];
            std::snprintf(name, sizeof name, "%s %zu, %.6g %s", kind, i + 1, modes[i].value, unit);
            set.fields.push_back({name, drawn.rows(modes[i].shape, modes[i].inner_shape).leftCols<3>()});
        }
    };
    add("vibration", result.vibration_modes, "Hz");
    add("buckling", result.buckling_modes, "times the load");
    return set;
}

std::vector<Eigen::Vector3d> displaced_nodes(const LineSet& lines, double scale) {
    std::vector<Eigen::Vector3d> places = lines.nodes;
    if (!lines.displacements) return places;
    for (std::size_t i = 0; i < places.size(); ++i) {
        places[i] += scale * lines.displacements->row(i).head<3>().transpose();
    }
    return places;
}

LineSet model_lines(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                    const reduction::Calibration& calibration, const reduction::Setting& setting,
                    std::span<const reduction::TileModel> models) {
    const reduction::TileModel& model = reduction::find_tile_model(calibration.model, models);
    const reduction::ModelTile tile(model, layout, pattern, setting);
    return frame_lines(tile.parts(reduction::parameter_values(calibration, model)).beams);
}

}  // namespace fretwork::exports

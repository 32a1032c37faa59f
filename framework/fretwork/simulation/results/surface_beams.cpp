// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/mechanics/node_states.hpp>
#include <fretwork/mechanics/results/section_stress.hpp>
#include <fretwork/reduction/scenarios/joints.hpp>
#include <fretwork/simulation/detail/joined_tiles.hpp>
#include <fretwork/simulation/detail/tile_builder.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <fretwork/simulation/results/surface_beams.hpp>

#include <algorithm>
#include <limits>
#include <map>

namespace fretwork::simulation {
namespace {

using mechanics::kDofsPerNode;
using mechanics::NodeValues;
using tiling::TileIndex;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::vector<TileIndex> painted_tiles(const tiling::Tessellation& tessellation) {
    std::vector<TileIndex> painted;
    for (std::size_t t = 0; t < tessellation.tiles.size(); ++t) {
        if (tessellation.tiles[t].pattern >= 0) painted.emplace_back(t);
    }
    return painted;
}

tiling::TessellationFan painted_fan(const Surface& surface, std::span<const TileIndex> painted) {
    if (painted.size() == surface.tessellation.tiles.size()) return surface_fan(surface);
    tiling::Tessellation part = surface.tessellation;
    part.tiles.clear();
    for (const TileIndex tile : painted) part.tiles.push_back(surface.tessellation.tiles[tile]);
    return tiling::assemble_fans(surface.layout, part);
}

/// The joint reaches of all beams, tile by tile.
std::vector<double> reaches_of(const Surface& surface, std::span<const TileIndex> painted) {
    std::map<std::pair<int, std::size_t>, pattern::Fan> fans;  // by pattern and number of sides
    std::vector<double> reaches;
    for (const TileIndex tile : painted) {
        const geometry::Polygon polygon = tiling::tile_polygon(surface.tessellation, tile);
        const int pattern = surface.tessellation.tiles[tile].pattern;
        auto& fan = fans[{pattern, polygon.size()}];
        if (fan.nodes.empty())
            fan = pattern::make_fan(surface.layout, tiling::pattern_of(surface.tessellation, tile)->pattern,
                                    static_cast<int>(polygon.size()));
        const auto own = reduction::joint_reaches(fan, pattern::place_fan(surface.layout, fan, polygon));
        reaches.insert(reaches.end(), own.begin(), own.end());
    }
    return reaches;
}

/// The starts of all tiles, from the starts of the painted tiles in `fan`.
std::vector<SurfaceBeams::Start> starts_of(const tiling::Tessellation& tessellation,
                                           const tiling::TessellationFan& fan) {
    std::vector<SurfaceBeams::Start> starts;
    SurfaceBeams::Start next{tessellation.interface_nodes.size(), 0};
    std::size_t painted = 0;
    for (const tiling::Tile& tile : tessellation.tiles) {
        starts.push_back(next);
        if (tile.pattern < 0) continue;
        next.inner_node += fan.tile_nodes[painted].size() - tile.interface_nodes.size();
        next.beam = fan.first_edge[painted + 1];
        ++painted;
    }
    starts.push_back(next);
    return starts;
}

/// Writes the values of tiles, also in parallel.
class StateWriter {
  public:
    StateWriter(const Surface& surface, const SurfaceBeams& beams,
                std::span<const mechanics::BeamSection> sections, BeamState& state)
        : tessellation_(surface.tessellation),
          bar_(surface.setting.section),  // the bars' own section: stiff joints do not change it
          beams_(beams),
          sections_(sections),
          state_(state) {}

    void write(TileIndex tile, const std::optional<reduction::BeamMotion>& motion) const {
        const std::size_t t = tile;
        const auto first = static_cast<Eigen::Index>(beams_.starts[t].inner_node);
        const auto count = static_cast<Eigen::Index>(beams_.starts[t + 1].inner_node) - first;
        if (!motion) return;
        state_.nodes.middleRows(first, count) = motion->nodes.bottomRows(count);
        if (!sections_.empty()) write_forces(t, *motion);
    }

  private:
    void write_forces(std::size_t tile, const reduction::BeamMotion& motion) const {
        const detail::TileRows row_of(tessellation_.tiles[tile].interface_nodes,
                                      {beams_.interface_nodes, beams_.starts[tile].inner_node});
        const NodeValues& rows = motion.in_axes.rows() > 0 ? motion.in_axes : motion.nodes;
        for (std::size_t b = beams_.starts[tile].beam; b < beams_.starts[tile + 1].beam; ++b) {
            const Eigen::Index from = row_of(beams_.ends[b][0]);
            const Eigen::Index to = row_of(beams_.ends[b][1]);
            const auto ends = motion.displacements == reduction::Displacements::Large
                                  ? sections_[b].large(mechanics::node_state(rows.row(from)),
                                                       mechanics::node_state(rows.row(to)))
                                  : sections_[b].linear(rows.row(from).transpose(), rows.row(to).transpose());
            for (std::size_t end = 0; end < 2; ++end) {
                const mechanics::SectionForces& f = ends[end];
                const mechanics::SectionStress stress = bar_.largest(f);
                state_.forces.row(static_cast<Eigen::Index>(2 * b + end)) << f.N, f.V2, f.V3, f.T, f.M2, f.M3,
                    stress.normal, stress.von_mises;
            }
        }
    }

    const tiling::Tessellation& tessellation_;
    mechanics::SectionPoints bar_;
    const SurfaceBeams& beams_;
    std::span<const mechanics::BeamSection> sections_;
    BeamState& state_;
};

struct StateRequest {
    const Surface& surface;
    const SurfaceBeams& beams;
    std::span<const mechanics::BeamSection> sections;
    int threads = 0;
    base::Control control{};
};

template <class MotionOf>
BeamState state_of(const StateRequest& request, const mechanics::Solution& solution,
                   const MotionOf& motion_of) {
    const SurfaceBeams& beams = request.beams;
    BeamState state;
    const auto interface_nodes = static_cast<Eigen::Index>(beams.interface_nodes);
    state.nodes.setConstant(static_cast<Eigen::Index>(beams.nodes.size()), kDofsPerNode, kUnknown);
    state.nodes.topRows(interface_nodes) = solution.displacements.topRows(interface_nodes);
    state.forces.setConstant(static_cast<Eigen::Index>(2 * request.sections.size()), std::ssize(kBeamFields),
                             kUnknown);
    const StateWriter writer(request.surface, beams, request.sections, state);
    base::parallel_for(beams.starts.size() - 1, request.threads, [&](std::size_t t) {
        request.control.check();
        writer.write(TileIndex(t), motion_of(TileIndex(t)));
    });
    return state;
}

/// The tiles of a result from a file, built again.
class ReadTiles {
  public:
    struct Origin {
        const Surface& surface;
        std::span<const reduction::TileModel> models;
        const base::Control& control;
    };
    ReadTiles(const Origin& origin, const SurfaceResult& result, const SurfaceBeams& beams)
        : surface_(origin.surface), models_(origin.models), control_(origin.control), result_(result) {
        const std::size_t rows = result.solution.displacements.rows();
        if (rows < beams.interface_nodes)
            throw base::InputError("the result is not one of this project: it has too few nodes");
        if (result.subject)
            build(main_model(*result.subject), result.subject->full_tiles);
        else if (rows == beams.nodes.size())
            build(reference_choice({.models = models_}).name, {});
        if (!tiles_.empty() && starts_.back() != rows)
            throw base::InputError("the result is not one of this project: its models have " +
                                   std::to_string(starts_.back()) + " nodes, and it has " +
                                   std::to_string(rows));
    }

    [[nodiscard]] BeamState state(const mechanics::Solution& solution, const SurfaceBeams& beams,
                                  std::span<const mechanics::BeamSection> sections) const {
        return state_of({surface_, beams, sections, 0, control_}, solution,
                        [&](TileIndex tile) { return beam_motion(tile, solution.displacements); });
    }

  private:
    [[nodiscard]] std::optional<reduction::BeamMotion> beam_motion(TileIndex tile,
                                                                   const NodeValues& rows) const {
        if (tiles_.empty()) return std::nullopt;
        const std::size_t t = tile;
        const bool is_linear = result_.solver == "linear";
        return tiles_[t].structure->beam_motion(
            {.nodes = detail::rows_of_tile(rows, surface_.tessellation.tiles[t].interface_nodes,
                                           {starts_[t], starts_[t + 1]}),
             .turn = tiles_[t].turn,
             .displacements = is_linear ? reduction::Displacements::Small : reduction::Displacements::Large});
    }

    void build(const std::string& model, std::span<const int> full_tiles) {
        Surface chosen = surface_;
        chosen.tile_models.resize(chosen.tessellation.tiles.size());
        for (const int tile : full_tiles) {
            if (tile < 0 || static_cast<std::size_t>(tile) >= chosen.tile_models.size())
                throw base::InputError("the result is not one of this project: it has a tile " +
                                       std::to_string(tile) + " in full");
            chosen.tile_models[tile] = reference_choice({.models = models_}).name;
        }
        tiles_ = detail::TileBuilder().build_all(chosen, model_choice({.model = model, .models = models_}),
                                                 {.control = control_});
        starts_.push_back(surface_.tessellation.interface_nodes.size());
        for (const detail::BuiltTile& tile : tiles_)
            starts_.push_back(starts_.back() + tile.structure->inner_nodes().size());
    }

    const Surface& surface_;
    std::span<const reduction::TileModel> models_;
    const base::Control& control_;
    const SurfaceResult& result_;
    std::vector<detail::BuiltTile> tiles_;
    std::vector<std::size_t> starts_;  ///< first inner node of each tile; last, the number of all nodes
};

}  // namespace

SurfaceBeams surface_beams(const Surface& surface) {
    const auto painted = painted_tiles(surface.tessellation);
    const tiling::TessellationFan fan = painted_fan(surface, painted);
    SurfaceBeams beams;
    beams.interface_nodes = surface.tessellation.interface_nodes.size();
    beams.nodes.reserve(fan.nodes.size());
    for (const geometry::Point2& node : fan.nodes) beams.nodes.emplace_back(node.x, node.y, 0.0);
    for (const tiling::TessellationFan::Edge& edge : fan.edges) {
        beams.ends.push_back(
            {mechanics::NodeIndex(edge.nodes[0].value), mechanics::NodeIndex(edge.nodes[1].value)});
        beams.tiles.push_back(painted[edge.tile]);
    }
    beams.starts = starts_of(surface.tessellation, fan);
    beams.joint_reaches = reaches_of(surface, painted);
    return beams;
}

bool has_nodes_at(const SurfaceResult& result, std::span<const Eigen::Vector3d> places) {
    return std::ranges::equal(result.nodes, places, [](const auto& node, const Eigen::Vector3d& place) {
        return (node.rest_position - place).norm() <= kSamePlace;
    });
}

std::vector<mechanics::BeamSection> beam_sections(const SurfaceBeams& beams,
                                                  const reduction::Setting& setting) {
    std::vector<mechanics::BeamSection> sections;
    sections.reserve(beams.ends.size());
    for (std::size_t i = 0; i < beams.ends.size(); ++i) {
        const auto& [a, b] = beams.ends[i];
        const std::array ends{beams.nodes[a], beams.nodes[b]};
        const reduction::TileMaterial bar = reduction::bar_of(
            setting, {.length = (ends[1] - ends[0]).norm(), .joint_reach = beams.joint_reaches[i]});
        sections.emplace_back(
            mechanics::Beam{.nodes = {a, b}, .section = bar.section, .material = bar.material}, ends);
    }
    return sections;
}

BeamState beam_state(const Session& session, const mechanics::Solution& solution, const SurfaceBeams& beams,
                     std::span<const mechanics::BeamSection> sections, const base::Control& control) {
    session.require_since_edit(solution);
    return state_of({session.surface(), beams, sections, session.options().threads, control}, solution,
                    [&](TileIndex tile) { return session.beam_motion(tile, solution); });
}

BeamState beam_state(const Surface& surface, const SurfaceResult& result, const SurfaceBeams& beams,
                     std::span<const mechanics::BeamSection> sections,
                     std::span<const reduction::TileModel> models, const base::Control& control) {
    return ReadTiles({surface, models, control}, result, beams).state(result.solution, beams, sections);
}

std::vector<BeamState> step_beam_states(const Surface& surface, const SurfaceResult& result,
                                        const SurfaceBeams& beams,
                                        std::span<const mechanics::BeamSection> sections,
                                        std::span<const reduction::TileModel> models,
                                        const base::Control& control) {
    const ReadTiles tiles({surface, models, control}, result, beams);
    std::vector<BeamState> states;
    for (const mechanics::Solution& end : result.load_steps)
        states.push_back(tiles.state(end, beams, sections));
    return states;
}

}  // namespace fretwork::simulation

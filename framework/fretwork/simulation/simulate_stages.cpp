// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/stopwatch.hpp>
#include <fretwork/mechanics/paths/staged_path.hpp>
#include <fretwork/simulation/detail/joined_tiles.hpp>
#include <fretwork/simulation/detail/tile_deformations.hpp>
#include <fretwork/simulation/detail/wanted.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/load_cases/stage_conditions.hpp>
#include <fretwork/simulation/mixed_model.hpp>
#include <fretwork/simulation/results/model_doubt.hpp>
#include <fretwork/simulation/results/model_error.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <fretwork/simulation/results/tile_stability.hpp>
#include <fretwork/simulation/stages.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace fretwork::simulation {
namespace {

using tiling::TileIndex;

/// The texts of the load cases that load stages name, in the order of the load cases' names.
std::vector<std::string> named_cases(const StagePlan& plan) {
    std::map<std::string, std::string> texts;
    for (const LoadStage& stage : plan.stages) {
        for (const LoadCase::Share& share : stage.loads)
            texts[share.load_case] = load_case_text(stage_load_case(plan, share.load_case));
    }
    std::vector<std::string> result;
    for (const auto& [name, text] : texts) result.push_back(text);
    return result;
}

/// The solutions of one surface at the ends of the load stages.
struct FollowedStages {
    SurfaceResult result;
    std::vector<TileDeformation> tiles;  ///< each at the end where its energy times its rotation is largest
    ModelDoubt doubt;                    ///< the largest of all ends
};

/// Follows the same load stages with one surface after another.
class StagedSimulation {
  public:
    StagedSimulation(const Surface& surface, const StagePlan& plan, const SimulationOptions& options,
                     const base::Control& control)
        : surface_(surface), plan_(plan), options_(options), control_(control) {}

    SurfaceResult run() {
        FollowedStages own = follow(surface_);
        SurfaceResult& result = own.result;
        const bool is_reduced = !is_reference(surface_, options_);
        const bool has_ended = result.solution.converged();
        if (options_.estimate_where_doubtful && has_ended && is_reduced) result.model_doubt = own.doubt;
        const bool is_doubted = options_.model == kMixedTiles && is_doubtful(result);
        if (has_ended && (options_.estimate_model_error || is_doubted)) estimate(own);
        if (has_ended && options_.estimate_model_error)
            result.buckled_tiles = tile_numbers(buckled_tiles(surface_, result.solution, options_, control_));
        detail::add_wanted(surface_, plan_.supports, options_, control_, result);
        return std::move(result);
    }

  private:
    FollowedStages follow(const Surface& surface) {
        const base::Stopwatch watch;
        const auto tiles = builder_.build_all(surface, model_choice(options_), {options_.threads, control_});
        const detail::JoinedTiles joined = detail::join_tiles(surface, tiles, control_);
        const mechanics::Assembly assembly = reduction::assemble(joined.parts, control_);
        FollowedStages followed;
        SurfaceResult& result = followed.result;
        result.nodes = detail::result_nodes(surface, assembly);
        result.load_steps = ends_of(surface, assembly);
        result.solution = result.load_steps.back();
        result.solver = "newton";
        result.seconds = watch.seconds();
        for (const mechanics::Solution& end : result.load_steps)
            add_deformations(detail::tile_deformations(assembly, joined.starts, end, control_), followed);
        result.subject = result_subject(surface, plan_.supports, options_);
        result.subject->stages_text = stages_text(plan_.stages);
        result.subject->stage_load_cases = named_cases(plan_);
        return followed;
    }

    [[nodiscard]] std::vector<mechanics::Solution> ends_of(const Surface& surface,
                                                           const mechanics::Assembly& assembly) const {
        StageConditions conditions(surface, plan_);
        mechanics::StagedPath path(
            assembly, {.branch = options_.branch, .threads = options_.threads, .control = control_});
        mechanics::NodeValues displacements =
            mechanics::NodeValues::Zero(assembly.reported_nodes, mechanics::kDofsPerNode);
        std::vector<mechanics::Solution> ends;
        for (const LoadStage& stage : plan_.stages) {
            ends.push_back(path.advance(conditions.advance(stage, displacements, assembly.nodes.size())));
            mechanics::require_sensible_motion(ends.back());
            if (!ends.back().converged()) break;
            displacements = ends.back().displacements;
        }
        return ends;
    }

    static void add_deformations(const std::vector<TileDeformation>& end, FollowedStages& followed) {
        followed.doubt.tile_rotation = std::max(followed.doubt.tile_rotation, model_doubt(end).tile_rotation);
        followed.tiles.resize(end.size());
        for (std::size_t t = 0; t < end.size(); ++t) {
            TileDeformation& worst = followed.tiles[t];
            if (end[t].energy * end[t].rotation > worst.energy * worst.rotation) worst = end[t];
        }
    }

    /// Follow all load stages again, with the worst tiles in full.
    void estimate(FollowedStages& own) {
        SurfaceResult& result = own.result;
        const double share = better_share(options_.model, own.doubt);
        Surface better = surface_;
        const std::vector<TileIndex> in_full = worst_tiles(surface_, own.tiles, share);
        put_in_full(in_full, better);
        FollowedStages reference = follow(better);
        result.model_error = staged_model_error(result, reference.result);
        if (!result.model_error) return;
        result.model_error->full_share = share_of(in_full, surface_);
        result.model_error->largest_stress = stress_error(better, std::move(reference), result);
    }

    void put_in_full(std::span<const TileIndex> tiles, Surface& surface) const {
        surface.tile_models.resize(surface.tessellation.tiles.size());
        for (const TileIndex tile : tiles) surface.tile_models[tile] = reference_choice(options_).name;
    }

    /// The relative error of the largest stress. Follows the load stages again until, for each of their ends,
    /// the tiles around the most stressed beam are in full.
    [[nodiscard]] std::optional<double> stress_error(Surface better, FollowedStages reference,
                                                     const SurfaceResult& result) {
        const std::vector<BeamTable> tables = step_beam_tables(surface_, result, options_.models, control_);
        while (true) {
            if (!reference.result.solution.converged()) return std::nullopt;
            const std::vector<BeamTable> refined =
                step_beam_tables(better, reference.result, options_.models, control_);
            const std::vector<TileIndex> missing = reduced_around_worst(better, refined);
            if (missing.empty()) return staged_stress_error(tables, refined);
            put_in_full(missing, better);
            reference = follow(better);
        }
    }

    [[nodiscard]] static std::vector<TileIndex> reduced_around_worst(const Surface& surface,
                                                                     std::span<const BeamTable> tables) {
        std::set<TileIndex> reduced;
        for (const BeamTable& table : tables) {
            if (table.rows.empty()) continue;
            for (const TileIndex tile : tiles_around(surface, most_stressed(table, 1).front())) {
                if (surface.tile_models[tile].empty()) reduced.insert(tile);
            }
        }
        return {reduced.begin(), reduced.end()};
    }

    const Surface& surface_;
    const StagePlan& plan_;
    const SimulationOptions& options_;
    const base::Control& control_;
    detail::TileBuilder builder_;
};

/// Refuse load stages and options that cannot be simulated.
void check(const Surface& surface, const StagePlan& plan, const SimulationOptions& options) {
    options.validate(surface);
    if (plan.stages.empty()) throw base::InputError("there is no load stage to simulate");
    if (!is_nonlinear(surface, options) || mixed_share(options.model) || options.load_steps > 1 ||
        options.estimate_error)
        throw base::InputError(
            "load stages are followed by full and corotational tiles, without load steps and estimates of "
            "the discretization error");
    if (options.estimate_model_error && options.model != kMixedTiles)
        throw base::InputError("through load stages, the error of " + std::string(kMixedTiles) +
                               " tiles is estimated, not that of " + options.model);
    check_stages(surface, plan);
}

}  // namespace

SurfaceResult simulate_stages(const Surface& surface, const StagePlan& plan, const SimulationOptions& options,
                              const base::Control& control) {
    check(surface, plan, options);
    return StagedSimulation(surface, plan, options, control).run();
}

}  // namespace fretwork::simulation

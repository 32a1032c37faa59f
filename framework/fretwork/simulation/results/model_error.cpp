// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/results/comparison.hpp>
#include <fretwork/simulation/results/model_error.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fretwork::simulation {

namespace {

/// The solution at the end of one load stage, without the subject, because that is of the whole path.
SurfaceResult end_of_stage(const SurfaceResult& result, std::size_t stage) {
    SurfaceResult end;
    end.nodes = result.nodes;
    end.solver = result.solver;
    end.solution = result.load_steps[stage];
    return end;
}

/// Norm over all interface nodes, m.
double translation_norm(const SurfaceResult& result) {
    double squares = 0.0;
    for (std::size_t i = 0; i < result.nodes.size(); ++i) {
        if (result.nodes[i].is_interface)
            squares +=
                result.solution.displacements.row(static_cast<Eigen::Index>(i)).head<3>().squaredNorm();
    }
    return std::sqrt(squares);
}

double largest_von_mises(const BeamTable& table) {
    return most_stressed(table, 1).front().largest_von_mises();
}

}  // namespace

double better_share(const std::string& model, const ModelDoubt& doubt) {
    if (doubt.tile_rotation > kFarRotation) return 1.0;
    const auto own = mixed_share(model);
    return own ? std::min(1.0, *own + kEstimatingShareOfMixed) : kEstimatingShare;
}

BetterSolution better_solution(Session& session, const SurfaceResult& own, const ModelDoubt& doubt,
                               const base::Control& control) {
    const double share = better_share(session.options().model, doubt);
    const SurfaceResult* plain = session.corotational_result();
    const SurfaceResult corotational = plain == nullptr ? own : *plain;
    if (!corotational.solution.converged()) return {corotational, {}};
    if (plain != nullptr) session.set_model(kMixedTiles);
    BetterSolution better;
    better.full_tiles =
        worst_tiles(session.surface(), session.tile_deformations(corotational.solution, control), share);
    if (!better.full_tiles.empty())
        session.set_tile_model(better.full_tiles, reference_choice(session.options()).name);
    better.result = session.solve(control);
    return better;
}

bool begins_with_own_solution(const Surface& surface, const SimulationOptions& options) {
    return is_nonlinear(surface, options) &&
           (options.model == kMixedTiles || mixed_share(options.model).has_value());
}

SimulationOptions estimating_options(const Surface& surface, SimulationOptions options) {
    options.estimate_model_error = false;
    if (begins_with_own_solution(surface, options)) return options;
    options.estimate_error = false;  // that of the beams of the result
    options.analysis = Analysis::OfTheModel;
    options.model = kMixedTiles;
    return options;
}

std::optional<ModelError> estimate_model_error(Session& session, const SurfaceResult& turned,
                                               const ModelDoubt& doubt, const Surface& surface,
                                               const SurfaceResult& result, const base::Control& control) {
    if (!result.solution.converged()) return std::nullopt;
    BetterSolution better = better_solution(session, turned, doubt, control);
    auto error = model_error(result, better.result);
    if (!error) return std::nullopt;
    error->full_share = share_of(better.full_tiles, surface);
    const BeamTable table = beam_table(surface, result, session.options().models, control);
    if (table.unknown > 0) return error;
    error->largest_stress = stress_error(
        table, refine_stress(session, std::move(better.result), std::move(better.full_tiles), control));
    return error;
}

double share_of(std::span<const tiling::TileIndex> tiles, const Surface& surface) {
    return static_cast<double>(tiles.size()) / static_cast<double>(surface.tessellation.tiles.size());
}

std::optional<ModelError> model_error(const SurfaceResult& result, const SurfaceResult& better) {
    if (!result.solution.converged() || !better.solution.converged()) return std::nullopt;
    const Comparison comparison = compare(better, result);
    if (comparison.max_displacement == 0.0) return ModelError{};
    return ModelError{.mean = comparison.mean_translation_error / comparison.max_displacement,
                      .largest = comparison.max_translation_error / comparison.max_displacement,
                      .relative_l2 = comparison.relative_l2_error};
}

std::optional<ModelError> staged_model_error(const SurfaceResult& result, const SurfaceResult& better) {
    ModelError error;
    double largest_displacement = 0.0;
    double largest_norm = 0.0;
    if (result.load_steps.size() != better.load_steps.size()) return std::nullopt;
    for (std::size_t i = 0; i < result.load_steps.size(); ++i) {
        const SurfaceResult own = end_of_stage(result, i);
        const SurfaceResult reference = end_of_stage(better, i);
        if (!own.solution.converged() || !reference.solution.converged()) return std::nullopt;
        const Comparison comparison = compare(reference, own);
        const double norm = translation_norm(reference);
        largest_displacement = std::max(largest_displacement, comparison.max_displacement);
        largest_norm = std::max(largest_norm, norm);
        error.mean = std::max(error.mean, comparison.mean_translation_error);
        error.largest = std::max(error.largest, comparison.max_translation_error);
        error.relative_l2 = std::max(error.relative_l2, comparison.relative_l2_error * norm);
    }
    if (largest_displacement == 0.0) return ModelError{};
    return ModelError{.mean = error.mean / largest_displacement,
                      .largest = error.largest / largest_displacement,
                      .relative_l2 = error.relative_l2 / largest_norm};
}

std::optional<double> staged_stress_error(std::span<const BeamTable> tables,
                                          std::span<const BeamTable> refined) {
    double error = 0.0;
    double reference = 0.0;
    for (std::size_t i = 0; i < tables.size(); ++i) {
        if (tables[i].rows.empty() || tables[i].unknown > 0 || refined[i].rows.empty()) return std::nullopt;
        reference = std::max(reference, largest_von_mises(refined[i]));
        error = std::max(error, std::abs(largest_von_mises(tables[i]) - largest_von_mises(refined[i])));
    }
    return reference == 0.0 ? 0.0 : error / reference;
}

std::optional<double> stress_error(const BeamTable& table, const RefinedStress& refined) {
    if (!refined.is_settled) return std::nullopt;
    return staged_stress_error({&table, 1}, {&refined.table, 1});
}

}  // namespace fretwork::simulation

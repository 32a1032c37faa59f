// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/simulation/results/comparison.hpp>
#include <fretwork/simulation/results/model_error.hpp>

#include <algorithm>
#include <cmath>

namespace fretwork::simulation {

std::string better_model(const std::string& model, const ModelDoubt& doubt) {
    const auto own = mixed_share(model);
    const bool needs_more = own || doubt.tile_rotation > kFarRotation;
    const double share =
        needs_more ? std::min(1.0, own.value_or(0.0) + kEstimatingShareOfMixed) : kEstimatingShare;
    return "mixed:" + base::format_number(share);
}

std::optional<ModelError> model_error(const SurfaceResult& result, const SurfaceResult& better) {
    if (!result.solution.converged() || !better.solution.converged()) return std::nullopt;
    const Comparison comparison = compare(better, result);
    if (comparison.max_displacement == 0.0) return ModelError{};
    return ModelError{.mean = comparison.mean_translation_error / comparison.max_displacement,
                      .largest = comparison.max_translation_error / comparison.max_displacement,
                      .relative_l2 = comparison.relative_l2_error};
}

std::optional<double> stress_error(const BeamTable& table, const RefinedStress& refined) {
    if (!refined.is_settled || table.rows.empty() || table.unknown > 0) return std::nullopt;
    const auto largest = [](const BeamTable& of) { return most_stressed(of, 1).front().largest_von_mises(); };
    const double reference = largest(refined.table);
    return reference == 0.0 ? 0.0 : std::abs(largest(table) - reference) / reference;
}

}  // namespace fretwork::simulation

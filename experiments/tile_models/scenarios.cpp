// SPDX-License-Identifier: GPL-3.0-or-later
#include "corotational_frame.hpp"
#include "scenarios.hpp"
#include "symmetric_stiffness.hpp"

#include <fretwork/base/parallel.hpp>
#include <fretwork/base/progress.hpp>
#include <fretwork/pattern/enumerate.hpp>
#include <fretwork/reduction/calibration/model_response.hpp>
#include <fretwork/reduction/calibration/objective.hpp>
#include <fretwork/reduction/stratified_sample.hpp>

#include <ctime>
#include <numeric>

namespace fretwork::tile_models {
namespace {

double thread_cpu_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// A model for large displacements is fitted by its linear ones, but judged by its own.
std::vector<double> own_errors(const reduction::TileModel& model, const reduction::CalibrationInput& input,
                               const reduction::Calibration& fitted) {
    const bool has_own = model.displacements == reduction::Displacements::Large && !model.parameters.empty();
    if (!has_own) return fitted.scenario_errors;
    const reduction::ModelTile tile(model, input.layout, input.pattern, input.setting);
    return reduction::Objective(input.responses, input.setting)
        .scenario_errors(tile.responses(reduction::parameter_values(fitted, model)));
}

/// A search over 44 parameters at random finds nothing: it begins near the pattern's own linear stiffness.
constexpr std::size_t kMostFromAnywhere = 10;

reduction::TileModel with_search_region(reduction::TileModel model,
                                        const reduction::CalibrationInput& input) {
    if (model.parameters.size() > kMostFromAnywhere)
        model.parameters =
            symmetric_stiffness_model(condensed_values(input.layout, input.pattern, input.setting))
                .parameters;
    return model;
}

reduction::CalibrationOptions options_for(const reduction::TileModel& model) {
    if (model.parameters.size() > kMostFromAnywhere) return {.starts = 1, .budget = 200000};
    return {};
}

struct Fit {
    reduction::Calibration calibration;
    double cpu_seconds = 0.0;
};

/// A corotational row is fitted as its linear one, which comes before it.
Fit fit_of(const reduction::TileModel& model, const reduction::CalibrationInput& input,
           const std::vector<Fit>& before) {
    for (const Fit& fit : before) {
        if (model.name != "corotational_" + fit.calibration.model) continue;
        Fit same = fit;
        same.calibration.model = model.name;
        return same;
    }
    const double start = thread_cpu_seconds();
    auto calibration = reduction::calibrate(model, input, options_for(model));
    return {std::move(calibration), thread_cpu_seconds() - start};
}

struct Examined {
    CalibratedPattern pattern;
    std::vector<ScenarioRow> rows;
};

Examined examine(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                 const reduction::Setting& setting) {
    const auto responses = reduction::compute_responses(layout, pattern, setting);
    const reduction::CalibrationInput input{layout, pattern, setting, responses};
    Examined result{{pattern, pattern::pattern_id(layout, pattern), {}}, {}};
    std::vector<Fit> fits;
    for (const reduction::TileModel& row : catalogue()) {
        const reduction::TileModel model = with_search_region(row, input);
        if (model.role == reduction::Role::Reference) continue;
        const Fit fit = fit_of(model, input, fits);
        const reduction::Calibration& fitted = fit.calibration;
        fits.push_back(fit);
        auto errors = own_errors(model, input, fitted);
        const double sum = std::accumulate(errors.begin(), errors.end(), 0.0);
        result.rows.push_back({result.pattern.id, model.name, model.parameters.size(), sum, std::move(errors),
                               fitted.cost, model.parameters.empty() ? 0.0 : fit.cpu_seconds,
                               fitted.at_bound.size()});
        if (!model.parameters.empty()) result.pattern.calibrations.push_back(fitted);
    }
    return result;
}

}  // namespace

const std::vector<reduction::TileModel>& catalogue() {
    static const std::vector<reduction::TileModel> rows = [] {
        std::vector<reduction::TileModel> all = reduction::tile_models();
        for (const char* name : {"paper6", "ring10"})
            all.push_back(corotational(reduction::find_tile_model(name)));
        all.push_back(symmetric_stiffness_model());
        all.push_back(corotational(symmetric_stiffness_model()));
        return all;
    }();
    return rows;
}

ScenarioStudy study_scenarios(const reduction::Setting& setting, std::size_t count, int threads) {
    const auto layout = pattern::find_node_layout("paper7");
    const auto all =
        pattern::enumerate_patterns(layout, {.edges = pattern::default_edge_range(layout), .filters = {}});
    const auto chosen = reduction::spread_over_edges(all, count);
    std::vector<Examined> examined(chosen.size());
    base::TerminalProgress progress;
    progress.start("patterns", chosen.size());
    constexpr std::size_t kBatch = 4;
    for (std::size_t begin = 0; begin < chosen.size(); begin += kBatch) {
        const std::size_t size = std::min(kBatch, chosen.size() - begin);
        base::parallel_for(size, threads, [&](std::size_t i) {
            examined[begin + i] = examine(layout, chosen[begin + i], setting);
        });
        progress.update(begin + size);
    }
    progress.finish();
    ScenarioStudy study;
    for (Examined& one : examined) {
        study.patterns.push_back(std::move(one.pattern));
        std::ranges::move(one.rows, std::back_inserter(study.rows));
    }
    return study;
}

}  // namespace fretwork::tile_models

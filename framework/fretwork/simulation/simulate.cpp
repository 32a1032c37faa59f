// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/simulation/detail/wanted.hpp>
#include <fretwork/simulation/results/model_error.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <fretwork/simulation/results/tile_stability.hpp>
#include <fretwork/simulation/session.hpp>
#include <fretwork/simulation/simulate.hpp>

#include <span>

namespace fretwork::simulation {
namespace {

std::vector<int> numbers(std::span<const tiling::TileIndex> tiles) {
    std::vector<int> result;
    for (const tiling::TileIndex tile : tiles) result.push_back(tile.value);
    return result;
}

/// The tiles of a corotational solution need not be solved again for its estimate.
bool is_corotational(const Surface& surface, const SimulationOptions& options) {
    return options.model == kMixedTiles && is_nonlinear(surface, options);
}

class Simulation {
  public:
    Simulation(const Surface& surface, const LoadCase& load_case, const SimulationOptions& options,
               const base::Control& control)
        : surface_(surface), load_case_(load_case), options_(options), control_(control) {}

    SurfaceResult run() {
        SurfaceResult result = options_.estimate_model_error ? solve_with_estimate() : solve();
        ResultSubject subject = result_subject(surface_, load_case_, options_);
        subject.full_tiles = std::move(full_tiles_);
        result.subject = std::move(subject);
        detail::add_wanted(surface_, load_case_, options_, control_, result);
        return result;
    }

  private:
    SurfaceResult solve() {
        Session session(surface_, load_case_, options_);
        SurfaceResult result = session.solve(control_);
        full_tiles_ = numbers(session.full_tiles());
        return result;
    }

    SurfaceResult solve_with_estimate() {
        SimulationOptions plain = options_;
        plain.estimate_model_error = false;
        SurfaceResult result;
        if (!is_corotational(surface_, options_))
            result = Session(surface_, load_case_, plain).solve(control_);
        SimulationOptions better = plain;
        better.analysis = Analysis::OfTheModel;
        better.model = "mixed:" + base::format_number(kEstimatingShare);
        Session session(surface_, load_case_, better);
        const SurfaceResult mixed = session.solve(control_);
        if (is_corotational(surface_, options_)) result = *session.corotational_result();
        result.model_error = model_error(result, mixed);
        if (result.model_error) {
            better.model = kMixedTiles;
            Session refining(surface_, load_case_, better);
            const RefinedStress refined = refine_stress(refining, session.full_tiles(), control_);
            result.subject = result_subject(surface_, load_case_, plain);
            result.model_error->largest_stress =
                stress_error(beam_table(surface_, result, options_.models), refined);
        }
        if (result.solution.converged())
            result.buckled_tiles = numbers(buckled_tiles(surface_, result.solution, options_, control_));
        return result;
    }

    const Surface& surface_;
    const LoadCase& load_case_;
    const SimulationOptions& options_;
    const base::Control& control_;
    std::vector<int> full_tiles_;
};

}  // namespace

SurfaceResult simulate(const Surface& surface, const LoadCase& load_case, const SimulationOptions& options,
                       const base::Control& control) {
    options.validate(surface);
    return Simulation(surface, load_case, options, control).run();
}

}  // namespace fretwork::simulation

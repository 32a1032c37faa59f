// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/detail/wanted.hpp>
#include <fretwork/simulation/results/model_doubt.hpp>
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

/// Corotational and mixed tiles: their estimate begins with their own solution, which the session keeps.
bool is_turning(const Surface& surface, const SimulationOptions& options) {
    return is_nonlinear(surface, options) &&
           (options.model == kMixedTiles || mixed_share(options.model).has_value());
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
        if (options_.estimate_where_doubtful && result.solution.converged() &&
            is_nonlinear(surface_, options_) && !is_reference(surface_, options_))
            add_doubt(session, result);
        return result;
    }

    void add_doubt(Session& session, SurfaceResult& result) {
        result.model_doubt = model_doubt(session, result);
        const bool can_estimate =
            options_.branch == mechanics::Branch::Primary && is_turning(surface_, options_);
        if (!is_doubtful(result) || !can_estimate) return;
        session.set_model(better_model(options_.model, *result.model_doubt));
        result.model_error = model_error(result, session.solve(control_));
    }

    SurfaceResult solve_with_estimate() {
        SimulationOptions plain = options_;
        plain.estimate_model_error = false;
        SimulationOptions better = plain;
        better.analysis = Analysis::OfTheModel;
        better.model = better_model(options_.model);
        Session session(surface_, load_case_, is_turning(surface_, options_) ? plain : better);
        SurfaceResult result;
        if (is_turning(surface_, options_)) {
            result = session.solve(control_);
            full_tiles_ = numbers(session.full_tiles());
            session.set_model(better.model);
        } else {
            result = Session(surface_, load_case_, plain).solve(control_);
        }
        result.model_error = model_error(result, session.solve(control_));
        if (result.model_error) estimate_stress(session.full_tiles(), better, result);
        if (result.solution.converged())
            result.buckled_tiles = numbers(buckled_tiles(surface_, result.solution, options_, control_));
        return result;
    }

    void estimate_stress(std::vector<tiling::TileIndex> full_tiles, SimulationOptions options,
                         SurfaceResult& result) {
        options.model = kMixedTiles;
        Session refining(surface_, load_case_, options);
        const RefinedStress refined = refine_stress(refining, std::move(full_tiles), control_);
        result.subject = result_subject(surface_, load_case_, options_);
        result.subject->full_tiles = full_tiles_;
        result.model_error->largest_stress =
            stress_error(beam_table(surface_, result, options_.models), refined);
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

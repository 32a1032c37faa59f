// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/detail/wanted.hpp>
#include <fretwork/simulation/results/model_doubt.hpp>
#include <fretwork/simulation/results/model_error.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <fretwork/simulation/results/tile_stability.hpp>
#include <fretwork/simulation/session.hpp>
#include <fretwork/simulation/simulate.hpp>

#include <vector>

namespace fretwork::simulation {
namespace {

class Simulation {
  public:
    Simulation(const Surface& surface, const LoadCase& load_case, const SimulationOptions& options,
               const base::Control& control)
        : surface_(surface), load_case_(load_case), options_(options), control_(control) {}

    SurfaceResult run() {
        SurfaceResult result = options_.estimate_model_error ? solve_with_estimate() : solve();
        if (!result.subject) add_subject(result);
        detail::add_wanted(surface_, load_case_, options_, control_, result);
        return result;
    }

  private:
    void add_subject(SurfaceResult& result) const {
        result.subject = result_subject(surface_, load_case_, options_, full_tiles_);
    }

    SurfaceResult solve() {
        Session session(surface_, load_case_, options_);
        SurfaceResult result = session.solve(control_);
        full_tiles_ = session.full_tiles();
        if (options_.estimate_where_doubtful && result.solution.converged() &&
            is_nonlinear(surface_, options_) && !is_reference(surface_, options_))
            add_doubt(session, result);
        return result;
    }

    void add_doubt(Session& session, SurfaceResult& result) {
        result.model_doubt = model_doubt(session, result, control_);
        if (is_doubtful(result) && begins_with_own_solution(surface_, options_))
            estimate(session, result, *result.model_doubt, result);
    }

    SurfaceResult solve_with_estimate() {
        SimulationOptions plain = options_;
        plain.estimate_model_error = false;
        Session session(surface_, load_case_, estimating_options(surface_, options_));
        const SurfaceResult turned = session.solve(control_);
        full_tiles_ = session.full_tiles();
        SurfaceResult result = begins_with_own_solution(surface_, options_)
                                   ? turned
                                   : Session(surface_, load_case_, plain).solve(control_);
        estimate(session, turned, model_doubt(session, turned, control_), result);
        if (result.solution.converged())
            result.buckled_tiles = tile_numbers(buckled_tiles(surface_, result.solution, options_, control_));
        return result;
    }

    /// Estimate the error of a result from a better solution than `turned`, the session's last solution.
    void estimate(Session& session, const SurfaceResult& turned, const ModelDoubt& doubt,
                  SurfaceResult& result) const {
        add_subject(result);
        result.model_error = estimate_model_error(session, turned, doubt, surface_, result, control_);
    }

    const Surface& surface_;
    const LoadCase& load_case_;
    const SimulationOptions& options_;
    const base::Control& control_;
    std::vector<tiling::TileIndex> full_tiles_;
};

}  // namespace

SurfaceResult simulate(const Surface& surface, const LoadCase& load_case, const SimulationOptions& options,
                       const base::Control& control) {
    options.validate(surface);
    return Simulation(surface, load_case, options, control).run();
}

}  // namespace fretwork::simulation

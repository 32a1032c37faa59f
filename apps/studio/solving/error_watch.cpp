// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/results/model_doubt.hpp>
#include <fretwork/simulation/results/model_error.hpp>
#include <studio/solving/error_watch.hpp>
#include <studio/solving/rest.hpp>

namespace fretwork::studio {

using base::Json;

namespace {

/// The event `model_error`; null if nothing is known.
Json error_of(const SolvedSurface& live, const base::Control& control) {
    const State& state = *live.situation.state;
    const std::string better = simulation::better_model(live.model, live.result.model_doubt.value());
    simulation::Session session(open_surface(state).surface, load_case_of(live.situation),
                                {.model = better, .analysis = state.analysis, .threads = 1});
    const auto error = simulation::model_error(live.result, session.solve(control));
    if (!error) return nullptr;
    return {{"event", "model_error"},
            {"revision", live.revision},
            {"model", live.model},
            {"mean", error->mean},
            {"largest", error->largest}};
}

bool wants_estimate(const SolvedSurface& solved) {
    return solved.result.solution.converged() && simulation::is_doubtful(solved.result) &&
           !simulation::is_reference(open_surface(*solved.situation.state).surface, {.model = solved.model});
}

}  // namespace

void ErrorWatch::begin() {
    thread_.cancel();
    looked_at_ = {};
    report_ = {};
}

void ErrorWatch::look_at(const SolvedPtr& solved) {
    if (looked_at_ == solved->situation) return;
    begin();
    if (is_unchecked(solved->result)) return;  // it comes again when the load rests
    looked_at_ = solved->situation;
    if (!solved->result.model_doubt) return;
    const auto look = [this, solved](const base::Control& control) {
        rest(control);
        if (!wants_estimate(*solved)) return;
        const Json event = error_of(*solved, control);
        if (event.is_null()) return;
        server_.post([this, of = solved->situation, event] { report(of, event); });
    };
    // Without an estimate the solution keeps its doubt, which pages show.
    thread_.add({.work = look, .failed = [](const std::string&) {}});
}

void ErrorWatch::report(const Situation& of, const Json& event) {
    if (!(looked_at_ == of) || !(of == now_())) return;
    report_ = {{text_part(event.dump())}};
    pages_.broadcast(report_);
}

}  // namespace fretwork::studio

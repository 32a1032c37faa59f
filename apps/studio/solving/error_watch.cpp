// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/results/model_doubt.hpp>
#include <fretwork/simulation/results/model_error.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <studio/solving/error_watch.hpp>
#include <studio/solving/rest.hpp>

namespace fretwork::studio {

using base::Json;

namespace {

/// The event `model_error`; null if nothing is known.
Json error_of(const SolvedSurface& live, const base::Control& control) {
    const State& state = *live.situation.state;
    const OpenedSurface opened = open_surface(state);
    const simulation::Surface& surface = opened.surface;
    const simulation::LoadCase load_case = load_case_of(live.situation);
    const simulation::SimulationOptions options{
        .model = live.model, .analysis = state.analysis, .threads = 1};
    simulation::Session session(surface, load_case, simulation::estimating_options(surface, options));
    const simulation::SurfaceResult turned = session.solve(control);
    simulation::SurfaceResult result = live.result;
    result.subject = simulation::result_subject(surface, load_case, options, live.full_tiles);
    const auto error = simulation::estimate_model_error(session, turned, result.model_doubt.value(), surface,
                                                        result, control);
    if (!error) return nullptr;
    return {{"event", "model_error"},
            {"revision", live.revision},
            {"model", live.model},
            {"mean", error->mean},
            {"largest", error->largest},
            {"largest_stress", base::or_null(error->largest_stress)},
            {"is_warned", error->largest > simulation::warned_error(*error)}};
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
    if (looked_at_ == solved->situation) {
        // Pages drop the report with every change, also with one that is taken back.
        if (looked_at_ == now_()) pages_.broadcast(report_);
        return;
    }
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
    if (!(looked_at_ == of)) return;
    report_ = {{json_part(event)}};
    if (of == now_()) pages_.broadcast(report_);
}

void ErrorWatch::send(ClientId client) {
    if (looked_at_ == now_()) pages_.send(client, report_);
}

}  // namespace fretwork::studio

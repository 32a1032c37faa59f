// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/results/comparison.hpp>
#include <studio/server/binary_messages.hpp>
#include <studio/server/outgoing.hpp>
#include <studio/solving/long_jobs.hpp>
#include <studio/solving/synced_session.hpp>

#include <utility>

namespace fretwork::studio {

using base::Json;

namespace {

/// A surface that is solved once, with the beams that were shown when it was asked for.
class OneSolve {
  public:
    OneSolve(const SolverInput& input, std::shared_ptr<const simulation::SurfaceBeams> beams,
             const simulation::SimulationOptions& options)
        : beams_(std::move(beams)),
          session_(open_surface(*input.situation.state).surface, load_case_of(input.situation), options) {
        if (input.fields.any()) sections_ = simulation::beam_sections(*beams_, session_.surface().setting);
    }

    simulation::SurfaceResult solve(const base::Control& control) { return session_.solve(control); }
    [[nodiscard]] simulation::BeamState state_in(const mechanics::Solution& solution) const {
        return simulation::beam_state(session_, solution, *beams_, sections_);
    }

  private:
    std::shared_ptr<const simulation::SurfaceBeams> beams_;
    simulation::Session session_;
    std::vector<mechanics::BeamSection> sections_;
};

/// The live thread needs the other processor.
simulation::SimulationOptions options_of(const State& state, const std::string& model) {
    return {.model = model, .analysis = state.analysis, .threads = 1};
}

SolvedSurface solved_in(const LongJob& job, simulation::SurfaceResult result) {
    SolvedSurface solved;
    solved.model = job.model;
    solved.situation = job.input.situation;
    solved.revision = job.input.revision;
    solved.beams_revision = job.beams.revision;
    solved.beams = job.beams.beams;
    solved.result = std::move(result);
    return solved;
}

Json job_event(const char* name, const LongJob& job, const Json& more) {
    Json event = {
        {"event", name}, {"revision", job.input.revision}, {"model", job.model}, {"background", true}};
    event.update(more);
    return event;
}

}  // namespace

std::size_t most_positions(const LongJob& job, const BeamFields& fields) {
    constexpr std::size_t kMostBytes = OutgoingQueue::kMostBytes / 4 * 3;
    return kMostBytes / solution_bytes(*job.beams.beams, fields);
}

JobWork solve_work() {
    return [](const LongJob& job, const base::Control& control) -> std::vector<Outgoing> {
        OneSolve one(job.input, job.beams.beams, options_of(*job.input.situation.state, job.model));
        SolvedSurface solved = solved_in(job, one.solve(control));
        solved.state = one.state_in(solved.result.solution);
        solved.warnings = warnings_of(solved.result);
        return {solved_message(solved, job.input.fields, Json{{"background", true}})};
    };
}

JobWork path_work(int steps) {
    return [steps](const LongJob& job, const base::Control& control) {
        auto options = options_of(*job.input.situation.state, job.model);
        options.load_steps = steps;
        OneSolve one(job.input, job.beams.beams, options);
        SolvedSurface solved = solved_in(job, one.solve(control));
        std::vector<Outgoing> messages;
        for (const mechanics::Solution& step : std::exchange(solved.result.load_steps, {})) {
            solved.result.solution = step;
            solved.state = one.state_in(step);
            solved.warnings = warnings_of(solved.result);
            messages.push_back(
                solved_message(solved, job.input.fields,
                               Json{{"background", true}, {"step", messages.size() + 1}, {"steps", steps}}));
        }
        return messages;
    };
}

JobWork modes_work(simulation::ModeKind kind, int count) {
    return [kind, count](const LongJob& job, const base::Control& control) -> std::vector<Outgoing> {
        const State& state = *job.input.situation.state;
        const auto modes =
            simulation::surface_modes(simulation::make_surface(make_project(state, "/"), nullptr),
                                      load_case_of(job.input.situation), kind, count, {control});
        Json values = Json::array();
        for (const mechanics::Mode& mode : modes) values.push_back(mode.value);
        const Json event = {{"event", "modes"},
                            {"revision", job.input.revision},
                            {"kind", kind == simulation::ModeKind::Buckling ? "buckling" : "vibration"},
                            {"values", values}};
        Outgoing message{{json_part(event)}};
        for (const mechanics::Mode& mode : modes)
            message.parts.push_back(
                binary_part(motion_message(mode.shape, {job.input.revision, job.beams.revision})));
        return {message};
    };
}

JobWork compare_work(SolvedPtr live) {
    return [live = std::move(live)](const LongJob& job,
                                    const base::Control& control) -> std::vector<Outgoing> {
        OneSolve one(job.input, job.beams.beams, options_of(*job.input.situation.state, job.model));
        const simulation::SurfaceResult reference = one.solve(control);
        const simulation::BeamState state = one.state_in(reference.solution);
        const auto comparison = simulation::compare(reference, live->result);
        const Json event = {{"event", "compared"},
                            {"revision", job.input.revision},
                            {"model", job.model},
                            {"live", live->model},
                            {"mean", comparison.mean_translation_error},
                            {"largest", comparison.max_translation_error},
                            {"relative", comparison.relative_l2_error},
                            {"fields", {"error"}}};
        const Eigen::MatrixXf error =
            (state.nodes - live->state.nodes).leftCols<3>().rowwise().norm().cast<float>();
        std::string positions = motion_message(state.nodes, {job.input.revision, job.beams.revision}, error);
        return {{{json_part(event), binary_part(std::move(positions))}}};
    };
}

LongJobs::LongJobs(HttpServer& server, Pages& pages, std::function<bool(const LongJob&)> is_shown)
    : server_(server), pages_(pages), is_shown_(std::move(is_shown)) {}

void LongJobs::add(const LongJob& job, JobWork work) {
    const auto report = [this, job](const char* name, const Json& more) {
        server_.post([this, event = job_event(name, job, more)] { pages_.broadcast(event); });
    };
    const auto run = [this, job, work = std::move(work)](const base::Control& control) {
        auto messages = std::make_shared<const std::vector<Outgoing>>(work(job, control));
        server_.post([this, job, messages] {
            if (!is_shown_(job)) return;
            for (const Outgoing& message : *messages) pages_.broadcast(message);
        });
    };
    thread_.add({.work = run,
                 .failed =
                     [report](const std::string& error) {
                         report("failed", {{"error", error}});
                     },
                 .progress =
                     [report](double share) {
                         report("solving", {{"share", share}});
                     }});
}

}  // namespace fretwork::studio

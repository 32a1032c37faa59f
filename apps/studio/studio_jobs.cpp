// SPDX-License-Identifier: GPL-3.0-or-later
// Long jobs that are asked for: other models, modes, the load path, comparisons.
#include <fretwork/base/error.hpp>
#include <fretwork/simulation/results/comparison.hpp>
#include <fretwork/simulation/results/surface_modes.hpp>
#include <studio/document/edits.hpp>
#include <studio/server/binary_messages.hpp>
#include <studio/server/words.hpp>
#include <studio/studio_impl.hpp>

#include <functional>

namespace fretwork::studio {

using base::Json;

namespace {

constexpr long long kMostModes = 50;
constexpr long long kMostSteps = 200;

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

}  // namespace

Studio::Impl::Job Studio::Impl::make_job(const Request& request, const std::string& model) {
    const Document& shown = document(request);
    if (!last_beams_ || last_beams_->revision != beams_revision_now())
        throw base::InputError("the surface is being built: try again in a moment");
    Job job{shown.solver_input(), last_beams_->beams, last_beams_->revision, model};
    job.input.fields = clients_.at(request.client);
    return job;
}

std::int64_t Studio::Impl::beams_revision_now() const {
    return last_beams_ && last_beams_->painting == document_->now()->painting &&
                   last_beams_->ground == document_->now()->ground
               ? last_beams_->revision
               : -1;
}

void Studio::Impl::start(const Request& request, Job job,
                         std::function<std::vector<Outgoing>(const Job&, const base::Control&)> work) {
    const auto told = [this, job](double share) {
        server_.post([this, job, share] {
            broadcast(Json{{"event", "solving"},
                           {"revision", job.input.revision},
                           {"model", job.model},
                           {"background", true},
                           {"share", share}});
        });
    };
    const auto failed = [this, job](const std::string& error) {
        server_.post([this, job, error] {
            broadcast(Json{{"event", "failed"},
                           {"revision", job.input.revision},
                           {"model", job.model},
                           {"background", true},
                           {"error", error}});
        });
    };
    jobs_.add({.work =
                   [this, job, work](const base::Control& control) {
                       auto messages = std::make_shared<const std::vector<Outgoing>>(work(job, control));
                       server_.post([this, job, messages] {
                           if (!is_shown(job.input.revision) || !document_ ||
                               job.beams_revision != beams_revision_now())
                               return;  // of other beams than those that are shown
                           for (const Outgoing& message : *messages) broadcast(message);
                       });
                   },
               .failed = failed,
               .told = told});
    answer(request);
}

SolvedSurface Studio::Impl::solved_in(const Job& job, simulation::SurfaceResult result) {
    SolvedSurface solved;
    solved.model = job.model;
    solved.situation = job.input.situation;
    solved.revision = job.input.revision;
    solved.beams_revision = job.beams_revision;
    solved.beams = job.beams;
    solved.result = std::move(result);
    return solved;
}

void Studio::Impl::solve(const Request& request) {
    request.json.allow_only({"id", "do", "model", "background"});
    if (const auto background = request.json.find("background"); background && !background->boolean())
        background->fail("is false, where only true is possible: the live model is solved by itself");
    start(request, make_job(request, read_model(request.json.at("model"), Mixed::Taken)),
          [](const Job& job, const base::Control& control) -> std::vector<Outgoing> {
              OneSolve one(job.input, job.beams, options_of(*job.input.situation.state, job.model));
              SolvedSurface solved = solved_in(job, one.solve(control));
              solved.state = one.state_in(solved.result.solution);
              solved.warnings = warnings_of(solved.result);
              return {solved_message(solved, job.input.fields, Json{{"background", true}})};
          });
}

void Studio::Impl::path(const Request& request) {
    request.json.allow_only({"id", "do", "steps"});
    const auto steps = request.json.at("steps").integer(2, kMostSteps);
    const std::string model = *document(request).now()->model;
    start(request, make_job(request, model), [steps](const Job& job, const base::Control& control) {
        auto options = options_of(*job.input.situation.state, job.model);
        options.load_steps = static_cast<int>(steps);
        OneSolve one(job.input, job.beams, options);
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
    });
}

void Studio::Impl::modes_of(const Request& request, simulation::ModeKind kind) {
    request.json.allow_only({"id", "do", "count"});
    const auto count = static_cast<int>(request.json.at("count").integer(1, kMostModes));
    const bool is_buckling = kind == simulation::ModeKind::Buckling;
    start(request, make_job(request, is_buckling ? "buckling" : "modes"),
          [count, kind, is_buckling](const Job& job, const base::Control& control) -> std::vector<Outgoing> {
              const State& state = *job.input.situation.state;
              const auto modes =
                  simulation::surface_modes(simulation::make_surface(make_project(state, "/"), nullptr),
                                            load_case_of(job.input.situation), kind, count, {control});
              Json values = Json::array();
              for (const mechanics::Mode& mode : modes) values.push_back(mode.value);
              const Json event = {{"event", "modes"},
                                  {"revision", job.input.revision},
                                  {"kind", is_buckling ? "buckling" : "vibration"},
                                  {"values", values}};
              Outgoing message{{text_part(event.dump())}};
              for (const mechanics::Mode& mode : modes)
                  message.parts.push_back(
                      binary_part(motion_message(mode.shape, {job.input.revision, job.beams_revision})));
              return {message};
          });
}

void Studio::Impl::modes(const Request& request) {
    modes_of(request, simulation::ModeKind::Vibration);
}

void Studio::Impl::buckling(const Request& request) {
    modes_of(request, simulation::ModeKind::Buckling);
}

void Studio::Impl::compare(const Request& request) {
    request.json.allow_only({"id", "do", "model"});
    const SolvedPtr live = last_solved_;
    Job job = make_job(request, read_model(request.json.at("model"), Mixed::Taken));
    if (!live || live->situation != job.input.situation)
        throw base::InputError(
            "there is no live solution to compare with: wait for it, or mend what keeps "
            "it from being solved");
    start(request, job, [live](const Job& asked, const base::Control& control) -> std::vector<Outgoing> {
        OneSolve one(asked.input, asked.beams, options_of(*asked.input.situation.state, asked.model));
        const simulation::SurfaceResult reference = one.solve(control);
        const simulation::BeamState state = one.state_in(reference.solution);
        const auto comparison = simulation::compare(reference, live->result);
        const Json event = {{"event", "compared"},
                            {"revision", asked.input.revision},
                            {"model", asked.model},
                            {"live", live->model},
                            {"mean", comparison.mean_translation_error},
                            {"largest", comparison.max_translation_error},
                            {"relative", comparison.relative_l2_error},
                            {"fields", {"error"}}};
        const Eigen::MatrixXf error =
            (state.nodes - live->state.nodes).leftCols<3>().rowwise().norm().cast<float>();
        std::string positions =
            motion_message(state.nodes, {asked.input.revision, asked.beams_revision}, error);
        return {{{text_part(event.dump()), binary_part(std::move(positions))}}};
    });
}

void Studio::Impl::cancel(const Request& request) {
    request.json.allow_only({"id", "do"});
    jobs_.cancel();
    answer(request);
}

}  // namespace fretwork::studio

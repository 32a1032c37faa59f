// SPDX-License-Identifier: GPL-3.0-or-later
// Requests for jobs that take long.
#include <fretwork/base/error.hpp>
#include <studio/document/edits.hpp>
#include <studio/studio_impl.hpp>

#include <string>

namespace fretwork::studio {
namespace {

constexpr long long kMostModes = 50;
constexpr long long kMostSteps = 200;

/// Refuses a number of steps or modes whose positions are too much to be sent to pages at once.
void check_size(const base::JsonReader& number, long long wanted, const LongJob& job,
                const BeamFields& fields) {
    const auto most = static_cast<long long>(most_positions(job, fields));
    if (wanted > most)
        number.fail("is " + std::to_string(wanted) + ", where a surface of this size allows " +
                    std::to_string(most) + (fields.any() ? " with the fields that are shown" : ""));
}

}  // namespace

LongJob Studio::Impl::make_job(const Request& request, const std::string& model) {
    const Document& shown = document();
    const ShownBeams* beams = view_.beams_of(*shown.now());
    if (beams == nullptr) throw base::InputError("the surface is being built: try again in a moment");
    LongJob job{shown.solver_input(), *beams, model};
    job.input.fields = pages_.fields(request.client);
    return job;
}

void Studio::Impl::solve(const Request& request) {
    request.json.allow_only({"id", "do", "model", "background"});
    if (const auto background = request.json.find("background"); background && !background->boolean())
        background->fail("is false, where only true is possible: the live model is solved by itself");
    jobs_.add(make_job(request, read_model(request.json.at("model"), Mixed::Taken)), solve_work());
    pages_.answer(request);
}

void Studio::Impl::path(const Request& request) {
    request.json.allow_only({"id", "do", "steps"});
    const auto steps = request.json.at("steps").integer(2, kMostSteps);
    const LongJob job = make_job(request, *document().now()->model);
    check_size(request.json.at("steps"), steps, job, job.input.fields);
    jobs_.add(job, path_work(static_cast<int>(steps)));
    pages_.answer(request);
}

void Studio::Impl::modes(const Request& request) {
    find_modes(request, simulation::ModeKind::Vibration);
}

void Studio::Impl::buckling(const Request& request) {
    find_modes(request, simulation::ModeKind::Buckling);
}

void Studio::Impl::find_modes(const Request& request, simulation::ModeKind kind) {
    request.json.allow_only({"id", "do", "count"});
    const auto count = static_cast<int>(request.json.at("count").integer(1, kMostModes));
    const char* name = kind == simulation::ModeKind::Buckling ? "buckling" : "modes";
    const LongJob job = make_job(request, name);
    check_size(request.json.at("count"), count, job, {});  // modes have no fields
    jobs_.add(job, modes_work(kind, count));
    pages_.answer(request);
}

void Studio::Impl::compare(const Request& request) {
    request.json.allow_only({"id", "do", "model"});
    const SolvedPtr live = view_.last_solved();
    const LongJob job = make_job(request, read_model(request.json.at("model"), Mixed::Taken));
    if (!live || live->situation != job.input.situation)
        throw base::InputError(
            "there is no live solution to compare with: wait for it, or mend what keeps "
            "it from being solved");
    jobs_.add(job, compare_work(live));
    pages_.answer(request);
}

void Studio::Impl::cancel(const Request& request) {
    request.json.allow_only({"id", "do"});
    jobs_.cancel();
    pages_.answer(request);
}

}  // namespace fretwork::studio

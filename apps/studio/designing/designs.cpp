// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <studio/designing/designs.hpp>
#include <studio/solving/synced_session.hpp>

#include <algorithm>
#include <typed/palette_text.hpp>
#include <utility>

namespace fretwork::studio {

using base::Json;
using design::DesignOptions;
using design::DesignReport;

namespace {

/// The sketch: as few solutions as show where a design leads. It costs a tenth to a third of the whole.
constexpr std::size_t kSketchedUniform = 6;
constexpr int kSketchedSolutions = 12;
/// Its share of a given time.
constexpr double kSketchedShare = 0.25;

std::vector<pattern::NamedPattern> palette_of(const State& state, const DesignWish& wish,
                                              const library::Library* library, const base::Control& control) {
    try {
        return typed::read_palette({wish.palette, wish.options.seed, control}, state.ground->layout, library);
    } catch (const base::InputError& error) {
        throw base::InputError("palette", "", error.data().problem);
    }
}

DesignOptions sketched(DesignOptions options) {
    options.uniform_paintings = kSketchedUniform;
    options.most_solutions = kSketchedSolutions;
    options.seconds *= kSketchedShare;
    return options;
}

bool is_nearer(const DesignReport& one, const DesignReport& other) {
    return one.error && (!other.error || one.error->mean < other.error->mean);
}

/// The result of the design: the answer, or the sketch if that is nearer to the target.
DesignReport best_of(const DesignReport& sketch, DesignReport answer) {
    if (!is_nearer(sketch, answer)) return answer;
    DesignReport best = sketch;
    best.end = answer.end;
    best.seconds += answer.seconds;
    best.solutions += answer.solutions;
    best.full_solutions += answer.full_solutions;
    const bool knows_better =
        answer.best_uniform && !(best.best_uniform && best.best_uniform->mean <= answer.best_uniform->mean);
    if (knows_better) {
        best.best_uniform = answer.best_uniform;
        best.best_uniform_pattern = answer.best_uniform_pattern;
    }
    best.uniform_tried = std::max(best.uniform_tried, answer.uniform_tried);
    return best;
}

bool is_same_task(const State& one, const State& other) {
    return one.ground == other.ground && one.painting == other.painting &&
           one.load_cases == other.load_cases && one.setting == other.setting;
}

}  // namespace

Designs::Designs(HttpServer& server, Pages& pages, std::function<void(const DesignFound&)> take)
    : server_(server), pages_(pages), take_(std::move(take)) {}

void Designs::show(const Json& event) {
    last_ = {{json_part(event)}};
    pages_.broadcast(last_);
}

void Designs::begin(const StatePtr& state, DesignWish wish, std::int64_t revision) {
    if (run_) throw base::InputError("a design is at work already: stop it first");
    const Work work{++number_, state, std::move(wish), revision};
    run_ = {state, revision};
    thread_.add({.work = [this, work](const base::Control& control) { run(work, control); },
                 .failed =
                     [this, number = work.number, revision](const std::string& error) {
                         server_.post([this, number, revision, error] { fail(number, revision, error); });
                     }});
}

void Designs::forget() {
    run_.reset();
    last_ = {};
    thread_.cancel();
}

void Designs::follow(const StatePtr& now) {
    if (!run_) {
        last_ = {};  // it was of another painting
        return;
    }
    if (is_same_task(*run_->state, *now)) return;
    const std::int64_t revision = run_->revision;
    forget();
    pages_.broadcast(
        Json{{"event", "failed"},
             {"revision", revision},
             {"model", "design"},
             {"background", true},
             {"error", "The surface was changed while it was being designed: the design has ended."}});
}

void Designs::painted(const StatePtr& now) {
    if (run_) run_->state = now;
}

/// On the design's thread.
void Designs::run(const Work& work, const base::Control& control) {
    const simulation::Project project = make_project(*work.state, "/");
    const auto library = work.wish.palette == "library" ? open_library(*work.state) : std::nullopt;
    const library::Library* given = library ? &*library : nullptr;
    DesignOptions options = work.wish.options;
    options.palette = palette_of(*work.state, work.wish, given, control);
    options.control = control.silent();
    options.on_better = [this, &work](const design::DesignProgress& progress) {
        tell_progress(work, progress);
    };
    const auto sketch = design::design(project, given, work.wish.target, sketched(options));
    if (sketch.end == design::DesignEnd::Stopped)
        return give(work, {DesignFound::Stage::Answer, sketch, work.wish.options});
    give(work, {DesignFound::Stage::Sketch, sketch, work.wish.options});
    options.seconds *= 1.0 - kSketchedShare;
    try {
        DesignReport answer = design::design(project, given, work.wish.target, options);
        give(work, {DesignFound::Stage::Answer, best_of(sketch, std::move(answer)), work.wish.options});
    } catch (const base::Stopped&) {  // before it had any painting: the sketch is the best so far
        DesignReport kept = sketch;
        kept.end = design::DesignEnd::Stopped;
        give(work, {DesignFound::Stage::Answer, std::move(kept), work.wish.options});
    }
}

void Designs::tell_progress(const Work& work, const design::DesignProgress& progress) {
    const Json event = {
        {"event", "designing"},  {"revision", work.revision},   {"solutions", progress.solutions},
        {"most", progress.most}, {"seconds", progress.seconds}, {"misfit", progress.misfit}};
    server_.post([this, number = work.number, event] {
        if (run_ && number == number_) show(event);
    });
}

void Designs::give(const Work& work, DesignFound found) {
    auto shared = std::make_shared<const DesignFound>(std::move(found));
    server_.post([this, number = work.number, shared] {
        if (!run_ || number != number_) return;
        take_(*shared);
        const std::int64_t revision = run_->revision;
        if (shared->stage == DesignFound::Stage::Answer) run_.reset();
        show(designed_event(*shared, revision));
    });
}

void Designs::fail(int number, std::int64_t revision, const std::string& error) {
    if (!run_ || number != number_) return;
    run_.reset();
    last_ = {};
    pages_.broadcast(Json{{"event", "failed"},
                          {"revision", revision},
                          {"model", "design"},
                          {"background", true},
                          {"error", error}});
}

}  // namespace fretwork::studio

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/simulation/results/model_doubt.hpp>
#include <studio/server/progress.hpp>
#include <studio/server/words.hpp>
#include <studio/solving/live_solver.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fretwork::studio {
namespace {

// While somebody drags, input comes faster than solves end: nothing would ever be seen if it stopped every
// solve. A solve that has shown nothing yet is stopped only if it has taken longer than the patience, and
// never after kLongestSilence without an answer.
constexpr std::chrono::milliseconds kLeastPatience{100};
constexpr std::chrono::milliseconds kMostPatience{400};
constexpr std::chrono::milliseconds kLongestSilence{1000};
/// During this time without an answer, newer input stops a solve whose first iterate is shown. After this
/// time, an equilibrium is due: first iterates become worse the farther they are from the last equilibrium.
constexpr std::chrono::milliseconds kLongestApproximation{200};
/// Loads that have not moved for so long are at rest.
constexpr std::chrono::milliseconds kRest{150};

}  // namespace

bool is_unchecked(const simulation::SurfaceResult& result) {
    return result.solver != "linear" && result.solution.stability == mechanics::StabilityTest::None;
}

std::vector<std::string> warnings_of(const simulation::SurfaceResult& result) {
    const mechanics::Solution& solution = result.solution;
    std::vector<std::string> warnings;
    if (!solution.converged())
        warnings.emplace_back("No equilibrium was found: the computation stopped at " +
                              std::to_string(std::lround(100 * solution.load_factor)) +
                              " % of the load. Make the load smaller, or hold the surface more.");
    if (solution.is_unstable())
        warnings.emplace_back("This equilibrium is not stable: the surface would snap into another shape.");
    if (simulation::is_doubtful(result))
        warnings.emplace_back(
            "This model may be off by some percent here: compare with the full model to see how far.");
    constexpr double kSmallTurn = 0.2;  // rad; the sine is off by 0.7 %
    if (result.solver == "linear" && solution.displacements.rows() > 0) {
        const double turn = solution.displacements.rightCols<3>().rowwise().norm().maxCoeff();
        if (turn > kSmallTurn)
            warnings.emplace_back(
                "A linear model is right for small displacements only, and this surface turns by " +
                std::to_string(std::lround(turn * 180 / std::numbers::pi)) +
                " degrees: choose a model for large displacements.");
    }
    return warnings;
}

LiveSolver::LiveSolver(SolverListener listener)
    : listener_(std::move(listener)), thread_([this](const std::stop_token& ending) { run(ending); }) {}

LiveSolver::~LiveSolver() {
    thread_.request_stop();
    const std::scoped_lock lock(mutex_);
    stop_.request_stop();
}

void LiveSolver::submit(SolverInput input) {
    const std::scoped_lock lock(mutex_);
    waiting_ = std::move(input);
    const auto now = Clock::now();
    if (!unanswered_since_) unanswered_since_ = now;
    if (is_to_be_stopped(now)) stop_.request_stop();
    changed_.notify_one();
}

bool LiveSolver::is_to_be_stopped(Clock::time_point now) const {
    if (!began_) return false;
    const auto silence = now - unanswered_since_.value();
    if (is_shown_) return silence <= kLongestApproximation;
    if (silence > kLongestSilence) return false;
    const auto patience = std::clamp<Clock::duration>(last_took_ * 3 / 2, kLeastPatience, kMostPatience);
    return now - began_.value() > patience;
}

std::optional<LiveSolver::Attempt> LiveSolver::next_attempt(const std::stop_token& ending) {
    std::unique_lock lock(mutex_);
    began_.reset();
    const auto has_input = [this] { return waiting_.has_value(); };
    if (unchecked_) {
        (void)changed_.wait_for(lock, ending, kRest, has_input);
    } else {
        (void)changed_.wait(lock, ending, has_input);
    }
    if (ending.stop_requested()) return std::nullopt;
    is_shown_ = !has_input();
    const auto check = has_input() ? mechanics::StabilityCheck::Skipped : mechanics::StabilityCheck::Made;
    Attempt attempt{std::move(has_input() ? waiting_ : unchecked_).value(), check, {}};
    waiting_.reset();
    unchecked_.reset();
    stop_ = std::stop_source();
    attempt.stop = stop_.get_token();
    began_ = Clock::now();
    return attempt;
}

void LiveSolver::let_overtake() {
    const std::scoped_lock lock(mutex_);
    is_shown_ = true;
    if (waiting_ && is_to_be_stopped(Clock::now())) stop_.request_stop();
}

void LiveSolver::end_attempt(Clock::time_point began) {
    const std::scoped_lock lock(mutex_);
    const auto now = Clock::now();
    last_took_ = now - began;
    unanswered_since_.reset();
    if (waiting_) unanswered_since_ = now;
}

void LiveSolver::run(const std::stop_token& ending) {
    while (const auto attempt = next_attempt(ending)) answer(*attempt);
}

void LiveSolver::answer(const Attempt& attempt) {
    const auto began = Clock::now();
    try {
        solve(attempt);
    } catch (const base::Stopped&) {
        return;  // newer input is there
    } catch (...) {
        listener_.failed(attempt.input, one_line(error_in_words()));
    }
    end_attempt(began);
}

void LiveSolver::update_beams(const SolverInput& input) {
    const StatePtr& state = input.situation.state;
    if (state_of_beams_ && state_of_beams_->ground == state->ground &&
        state_of_beams_->painting == state->painting)
        return;
    sections_.clear();
    const simulation::Surface surface = simulation::make_surface(make_project(*state, "/"), nullptr);
    beams_ = std::make_shared<const simulation::SurfaceBeams>(simulation::surface_beams(surface));
    state_of_beams_ = state;
    beams_revision_ = input.revision;
    listener_.beams({beams_, beams_revision_, state->ground, state->painting});
}

std::span<const mechanics::BeamSection> LiveSolver::wanted_sections(const SolverInput& input) {
    if (input.fields.none()) return {};
    const State& state = *input.situation.state;
    if (sections_.empty() || setting_of_sections_ != state.setting) {
        sections_ = simulation::beam_sections(*beams_, *state.setting);
        setting_of_sections_ = state.setting;
    }
    return sections_;
}

/// If only further fields are asked for, the solution is kept.
simulation::SurfaceResult LiveSolver::result_of(const Attempt& attempt) {
    const SolverInput& input = attempt.input;
    const bool is_known = last_solved_ && last_situation_ == input.situation;
    const bool is_enough = is_known && (attempt.check == mechanics::StabilityCheck::Skipped ||
                                        !is_unchecked(last_solved_->result));
    if (is_enough) return last_solved_->result;
    last_solved_.reset();
    ShareProgress progress([&](double share) { listener_.progress(input, share); });
    simulation::Session& session = session_.follow(input.situation);
    // While loads are dragged, people see where they lead before the answer is there.
    const mechanics::FirstIterate tell_first = [&](const mechanics::Solution& solution) {
        simulation::SurfaceResult first;
        first.solver = "newton";
        first.solution = solution;
        auto ahead = shown_as(input, std::move(first));
        ahead->stage = Stage::FirstIterate;
        listener_.solved(std::move(ahead));
        let_overtake();
    };
    simulation::SurfaceResult result = session.solve(
        {.stop = attempt.stop, .progress = &progress}, attempt.check,
        attempt.check == mechanics::StabilityCheck::Skipped ? tell_first : mechanics::FirstIterate());
    if (result.solver != "linear" && result.solution.converged())
        result.model_doubt = simulation::model_doubt(session, result);
    return result;
}

std::shared_ptr<SolvedSurface> LiveSolver::shown_as(const SolverInput& input,
                                                    simulation::SurfaceResult result) {
    auto shown = std::make_shared<SolvedSurface>();
    shown->model = *input.situation.state->model;
    shown->situation = input.situation;
    shown->revision = input.revision;
    shown->beams_revision = beams_revision_;
    shown->beams = beams_;
    shown->state = simulation::beam_state(*session_, result.solution, *beams_, wanted_sections(input));
    shown->full_tiles = (*session_).full_tiles();
    shown->result = std::move(result);
    return shown;
}

void LiveSolver::solve(const Attempt& attempt) {
    const SolverInput& input = attempt.input;
    update_beams(input);
    auto solved = shown_as(input, result_of(attempt));
    const simulation::SurfaceResult& result = solved->result;
    if (is_unchecked(result) && result.solution.converged() &&
        attempt.check == mechanics::StabilityCheck::Skipped)
        unchecked_ = input;
    solved->warnings = warnings_of(result);
    last_solved_ = solved;
    last_situation_ = input.situation;
    listener_.solved(std::move(solved));
}

}  // namespace fretwork::studio

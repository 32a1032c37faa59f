// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/simulation/results/surface_beams.hpp>
#include <studio/server/binary_messages.hpp>
#include <studio/solving/synced_session.hpp>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace fretwork::studio {

/// A document to be solved.
struct SolverInput {
    Situation situation;
    std::int64_t revision = 0;  ///< of the document
    BeamFields fields{};        ///< that somebody shows
};

/// The kind of positions. FirstIterate: the first step towards an equilibrium. Answer: an equilibrium, or the
/// end of the search for one.
enum class Stage { FirstIterate, Answer };

/// An equilibrium, and the beams that it moves.
struct SolvedSurface {
    Stage stage = Stage::Answer;
    std::string model;
    Situation situation;        ///< the one that was solved; several revisions may have it
    std::int64_t revision = 0;  ///< of the document when it was asked for
    std::int64_t beams_revision = 0;
    std::shared_ptr<const simulation::SurfaceBeams> beams;
    simulation::SurfaceResult result;
    /// The tiles with all of their beams in a mixed model, ascending.
    std::vector<tiling::TileIndex> full_tiles{};
    simulation::BeamState state;  ///< of the beams; with forces if any field was wanted
    std::vector<std::string> warnings{};
};
using SolvedPtr = std::shared_ptr<const SolvedSurface>;

/// The beams of a document's painting.
struct ShownBeams {
    std::shared_ptr<const simulation::SurfaceBeams> beams;
    std::int64_t revision = 0;  ///< for which they were made
    State::Part<simulation::Project> ground;
    State::Part<Painting> painting;
};

/// The receiver of the solver's results, on the solver's thread.
struct SolverListener {
    std::function<void(const ShownBeams&)> beams;
    /// The first iterate of an input may come before its answer or, if newer input came, instead of it.
    std::function<void(SolvedPtr)> solved;
    std::function<void(const SolverInput&, const std::string& error)> failed;
    std::function<void(const SolverInput&, double share)> progress;
};

/// Solves the newest input on its own thread. Nothing is queued: input that comes during a solve replaces
/// waiting input, and a long solve is stopped for it.
class LiveSolver {
  public:
    explicit LiveSolver(SolverListener listener);
    LiveSolver(const LiveSolver&) = delete;
    LiveSolver& operator=(const LiveSolver&) = delete;
    ~LiveSolver();

    void submit(SolverInput input);

  private:
    using Clock = std::chrono::steady_clock;
    /// The next input, and the token that stops its solve. New input is first solved without a check of
    /// stability. The check follows if no newer input comes for a moment.
    struct Attempt {
        SolverInput input;
        mechanics::StabilityCheck check = mechanics::StabilityCheck::Made;
        std::stop_token stop;
    };
    void run(const std::stop_token& ending);
    std::optional<Attempt> next_attempt(const std::stop_token& ending);
    /// Let newer input stop the solve, now that its first iterate is shown.
    void let_overtake();
    void end_attempt(Clock::time_point began);
    [[nodiscard]] bool is_to_be_stopped(Clock::time_point now) const;
    void answer(const Attempt& attempt);
    void solve(const Attempt& attempt);
    [[nodiscard]] simulation::SurfaceResult result_of(const Attempt& attempt);
    [[nodiscard]] std::shared_ptr<SolvedSurface> shown_as(const SolverInput& input,
                                                          simulation::SurfaceResult result);
    [[nodiscard]] std::span<const mechanics::BeamSection> wanted_sections(const SolverInput& input);
    void update_beams(const SolverInput& input);

    SolverListener listener_;
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::optional<SolverInput> waiting_;
    std::stop_source stop_;
    std::optional<Clock::time_point> began_{};             ///< start of the present solve
    bool is_shown_ = false;                                ///< true: its answer or first iterate is shown
    std::optional<Clock::time_point> unanswered_since_{};  ///< time of the first input without an answer
    Clock::duration last_took_{};                          ///< duration of the last solve not stopped

    // For the thread alone:
    SyncedSession session_;
    std::optional<SolverInput> unchecked_{};  ///< answered, except for its stability
    SolvedPtr last_solved_;                   ///< the session's last solution; null: none yet
    Situation last_situation_;                ///< the situation of that solution
    StatePtr state_of_beams_;
    std::shared_ptr<const simulation::SurfaceBeams> beams_;
    std::int64_t beams_revision_ = 0;
    std::vector<mechanics::BeamSection> sections_;  ///< of the beams; empty: to be made
    State::Part<reduction::Setting> setting_of_sections_;

    std::jthread thread_;
};

/// Whether the stability of a solution was left open, to answer sooner.
bool is_unchecked(const simulation::SurfaceResult& result);

/// The warnings about a result, for people: it did not converge, it is unstable, its model may be far off, or
/// it is linear and turns far.
std::vector<std::string> warnings_of(const simulation::SurfaceResult& result);

}  // namespace fretwork::studio

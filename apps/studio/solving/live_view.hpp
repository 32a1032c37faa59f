// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <studio/server/pages.hpp>
#include <studio/solving/live_solver.hpp>

#include <optional>
#include <string>

namespace fretwork::studio {

/// The answer that a file is to show. Both parts are empty if the file shows no answer.
struct AnswerToExport {
    SolvedPtr solved;
    std::string missing;  ///< the reason for a missing answer
};

/// The event and the message of a solution. With `more` in the event, newer solutions do not replace it.
Outgoing solved_message(const SolvedSurface& solved, const BeamFields& fields, const base::Json& more = {});

/// Sends the newest results of the live solver for the shown document to the pages, and keeps them for pages
/// that come later, for files and for comparisons. Used on the server's thread.
class LiveView {
  public:
    explicit LiveView(Pages& pages) : pages_(pages) {}

    /// Another document is shown, from this revision on.
    void begin(std::int64_t first_revision);
    /// Whether a revision is one of the document that is shown.
    [[nodiscard]] bool is_shown(std::int64_t revision) const {
        return first_revision_ && revision >= *first_revision_;
    }

    // Take a result. Pre: it is one of the shown document (see is_shown).
    void take_beams(const ShownBeams& shown);
    void take_solution(const SolvedPtr& solved);
    void take_failure(const SolverInput& input, const std::string& error);
    void take_progress(const SolverInput& input, double share);

    /// Send a page the last beams.
    void send_beams(ClientId client) { pages_.send(client, beams_message_); }
    /// Send a page the last solution, or the reason why there is none. False if it lacks the fields that the
    /// page shows.
    [[nodiscard]] bool send_solution(ClientId client);

    [[nodiscard]] const SolvedPtr& last_solved() const { return last_solved_; }
    /// The beams of a state; null while they are being built.
    [[nodiscard]] const ShownBeams* beams_of(const State& state) const;
    /// The answer to a situation; nothing as long as the solver is at work on it.
    [[nodiscard]] std::optional<AnswerToExport> answer_to(const Situation& situation) const;

  private:
    struct Failure {
        Situation situation;
        std::string reason;  ///< for people
    };

    Pages& pages_;
    std::optional<std::int64_t> first_revision_;  ///< of the document; none: there is no document
    std::optional<ShownBeams> last_beams_;
    Outgoing beams_message_;
    SolvedPtr last_solved_;     ///< null: none yet, or the solver failed
    Outgoing failure_message_;  ///< instead of a solution
    std::optional<Failure> last_failure_;
};

}  // namespace fretwork::studio

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/results/surface_modes.hpp>
#include <studio/server/background.hpp>
#include <studio/solving/live_view.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace fretwork::studio {

/// A job on the document as it was when a page asked.
struct LongJob {
    SolverInput input;
    ShownBeams beams;
    std::string model;  ///< as events name it
};
/// The largest number of positions with these fields that pages can be sent at once, beside other messages.
std::size_t most_positions(const LongJob& job, const BeamFields& fields);
/// Makes the messages to pages.
using JobWork = std::function<std::vector<Outgoing>(const LongJob&, const base::Control&)>;

JobWork solve_work();
JobWork path_work(int steps);
JobWork modes_work(simulation::ModeKind kind, int count);
/// Compares the job's model with the live solution.
JobWork compare_work(SolvedPtr live);

/// Jobs that take long, one after the other on their own thread: other models, modes, the load path,
/// comparisons. Used on the server's thread.
class LongJobs {
  public:
    /// @param is_shown  whether a job's beams are those that are shown; otherwise its messages are dropped
    LongJobs(HttpServer& server, Pages& pages, std::function<bool(const LongJob&)> is_shown);
    /// Throws InputError if too many are waiting.
    void add(const LongJob& job, JobWork work);
    /// Stop the running job and forget the waiting ones; pages see each of them fail.
    void cancel() { thread_.cancel(); }

  private:
    HttpServer& server_;
    Pages& pages_;
    std::function<bool(const LongJob&)> is_shown_;
    Background thread_;
};

}  // namespace fretwork::studio

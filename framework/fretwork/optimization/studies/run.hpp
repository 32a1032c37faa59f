// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/borrowed.hpp>
#include <fretwork/optimization/minimize.hpp>
#include <fretwork/optimization/studies/contender.hpp>

#include <compare>
#include <cstdint>
#include <string>

namespace fretwork::optimization::study {

/// The identity of a run in a study.
struct RunKey {
    std::string problem;    ///< its id
    std::string optimizer;  ///< name of the method, with its starts
    int repetition = 0;     ///< from 1
    friend auto operator<=>(const RunKey&, const RunKey&) = default;
};

/// The conditions that all runs of a study share.
struct RunConditions {
    optimization::Budget budget{.cost = 40000};  ///< the published annealing ends before this cost
    std::uint64_t seed = 1;                      ///< changes the seeds of all runs
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// One run: a row of the table (see run_table.hpp).
struct RunRecord {
    RunKey key;                                                               ///< which run
    int dimension = 0;                                                        ///< number of variables
    optimization::OptimizerClass kind = optimization::OptimizerClass::Local;  ///< class of the method
    int starts = 0;                                                           ///< descents
    std::uint64_t seed = 0;                                                   ///< of the run
    long budget = 0;                                                          ///< in the problem's unit
    optimization::OptimizationReport report;                                  ///< what came out
    double last_value = 0.0;  ///< the objective at the point where the method itself ended; not charged
    double distance = -1.0;   ///< largest component of the distance from the known optimum, as a share of the
                              ///< box; negative: not known
    double cpu_seconds = 0.0;  ///< processor time of the thread
};

/// The seed of a run: a hash of its key and the study's seed.
std::uint64_t run_seed(const RunKey& key, std::uint64_t study_seed);

/// The subject of a run: a problem and, if its minimum is known to be at one point, that point (else empty).
struct RunTarget {
    base::Borrowed<optimization::Problem> problem;  ///< what is minimized
    Eigen::VectorXd optimum{};                      ///< where the least known value is, if that is known
};

/// Run a contender on a problem. Throws base::Stopped once the budget's control asks to stop.
RunRecord record_run(const RunTarget& target, const Contender& contender, const RunKey& key,
                     const RunConditions& conditions);

}  // namespace fretwork::optimization::study

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
    std::string problem;    ///< id of the problem
    std::string optimizer;  ///< name of the method
    int repetition = 0;     ///< number of the repetition, from 1
    friend auto operator<=>(const RunKey&, const RunKey&) = default;
};

/// The conditions that all runs of a study share.
struct RunConditions {
    /// Limits of each run; the published annealing ends before this cost.
    optimization::Budget budget{.cost = 40000};
    /// The study's seed, from which the seeds of all runs follow.
    std::uint64_t seed = 1;
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// The record of one run, a row of the table in run_table.hpp.
struct RunRecord {
    RunKey key;                                                               ///< identity of the run
    int dimension = 0;                                                        ///< number of variables
    optimization::OptimizerClass kind = optimization::OptimizerClass::Local;  ///< class of the method
    int starts = 0;                                                           ///< number of starts
    std::uint64_t seed = 0;                                                   ///< seed of the run
    /// Largest cost, in the problem's unit.
    long budget = 0;
    optimization::OptimizationReport report;  ///< outcome of the run
    /// Objective at the final point of the method; its evaluation is not charged. The best objective if the
    /// final point is not known or outside the bounds.
    double last_value = 0.0;
    /// Largest component of the distance between the best point and the known optimum, as a share of the box;
    /// negative: the optimum is not known, or the run has no best point.
    double distance = -1.0;
    double cpu_seconds = 0.0;  ///< processor time of the thread
    std::string command{};     ///< command of a method that is a program of its own, else empty
};

/// The seed of a run: a hash of its key and the study's seed.
std::uint64_t run_seed(const RunKey& key, std::uint64_t study_seed);

/// The subject of a run: a problem and the point of its minimum.
struct RunTarget {
    base::Borrowed<optimization::Problem> problem;  ///< the problem to minimize
    Eigen::VectorXd optimum{};                      ///< the point of the minimum; empty: not known
};

/// Run a contender on a problem. Throws as optimization::minimize().
RunRecord record_run(const RunTarget& target, const Contender& contender, const RunKey& key,
                     const RunConditions& conditions);

}  // namespace fretwork::optimization::study

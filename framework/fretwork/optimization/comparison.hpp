// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer_catalogue.hpp>

#include <map>
#include <span>
#include <string>
#include <vector>

namespace fretwork::optimization {

/// A method as it takes part in a comparison, with restarts as a part of it.
struct Contender {
    const OptimizerRow* method = nullptr;
    int starts = 1;
};

/// All methods of the catalogue with the number of starts that the comparison gives them: enough that a
/// method made of short descents is no worse off than one whose single run takes long.
std::vector<Contender> default_contenders();

/// What identifies a run in a comparison.
struct RunKey {
    std::string problem;
    std::string optimizer;
    int repetition = 0;  ///< from 1
    friend auto operator<=>(const RunKey&, const RunKey&) = default;
};

/// The conditions that all runs of a comparison share.
struct ComparisonOptions {
    Budget budget{.cost = 40000};  ///< the published annealing ends before
    std::uint64_t seed = 1;        ///< changes the seeds of all runs
    void validate() const;
};

/// One run: the row of the table that comparison_header() names.
struct RunRecord {
    RunKey key;
    int dimension = 0;
    OptimizerClass kind = OptimizerClass::Local;
    int starts = 0;
    std::uint64_t seed = 0;
    long budget = 0;
    OptimizationReport report;
    double last_value = 0.0;  ///< the objective where the method itself stopped; not charged
    double distance = -1.0;  ///< from the known optimum, as the largest share of the box; negative: not known
    double cpu_seconds = 0.0;  ///< of the thread
};

/// The seed of a run: a hash of its key and the comparison's seed, so that no two runs share one.
std::uint64_t run_seed(const RunKey& key, std::uint64_t comparison_seed);

/// Run a contender on a problem. `optimum`: where the minimum is known to be, or empty.
RunRecord record_run(const Problem& problem, const Contender& contender, const RunKey& key,
                     const ComparisonOptions& options, const Eigen::VectorXd& optimum = {});

/// A deterministic method is run once, whatever number of repetitions is asked for.
int repetitions_of(const Contender& contender, int wanted);

/// The table of runs as CSV, one line a run. The trace is thinned to points at which what the run still gains
/// until its end is a fifth less, and the last.
std::string comparison_header();
std::string comparison_row(const RunRecord& record);

/// The rows of a table, sorted by their keys; what is done need not be run again.
class ComparisonTable {
  public:
    ComparisonTable() = default;
    /// Throws InputError that names file and line if a line is no row of such a table, or was made under
    /// another budget, seed or number of starts than these.
    ComparisonTable(std::string_view text, const std::string& source, const ComparisonOptions& options,
                    std::span<const Contender> contenders);

    [[nodiscard]] bool contains(const RunKey& key) const { return rows_.contains(key); }
    [[nodiscard]] std::size_t size() const { return rows_.size(); }
    void add(const RunRecord& record);
    [[nodiscard]] std::string csv() const;

  private:
    std::map<RunKey, std::string> rows_;
};

}  // namespace fretwork::optimization

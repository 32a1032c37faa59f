// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/studies/run.hpp>

#include <map>
#include <span>
#include <string>
#include <string_view>

namespace fretwork::optimization::study {

/// The names of the table's columns, joined by commas.
std::string run_table_header();
/// True for the header of a table of runs. Tables of earlier versions lack the last column, `command`.
bool is_run_table_header(std::string_view line);

/// A run as one line of CSV. The trace is thinned: a point is kept if its difference from the final value is
/// at least a fifth smaller than at the last kept point. The first and the last point are always kept.
std::string run_table_row(const RunRecord& record);

/// The runs of a table, sorted by their keys. A study does not repeat a run that is in its table.
class RunTable {
  public:
    RunTable() = default;
    /// Parse a table. Throws InputError that names file and line if a line is not a row of a table of runs,
    /// if its budget, seed, number of starts or command differs from `conditions` or `contenders`, or if its
    /// run appears twice.
    RunTable(std::string_view text, const std::string& source, const RunConditions& conditions,
             std::span<const Contender> contenders);

    /// True if the run is in the table.
    [[nodiscard]] bool contains(const RunKey& key) const { return rows_.contains(key); }
    /// The number of runs.
    [[nodiscard]] std::size_t size() const { return rows_.size(); }
    /// Add a run that is not in the table.
    void add(const RunRecord& record);
    /// Add the runs of another table that this table lacks.
    void merge(RunTable other) { rows_.merge(other.rows_); }
    /// The table as CSV, sorted.
    [[nodiscard]] std::string csv() const;

  private:
    std::map<RunKey, std::string> rows_;
};

}  // namespace fretwork::optimization::study

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

/// A run as one line of CSV. The trace is thinned to points at which what the run still gains until its end
/// is a fifth less, and the last.
std::string run_table_row(const RunRecord& record);

/// The rows of a table, sorted by their keys; what is done need not be run again.
class RunTable {
  public:
    RunTable() = default;
    /// Throws InputError that names file and line if a line is no row of such a table, or was made under
    /// another budget, seed or number of starts than these.
    RunTable(std::string_view text, const std::string& source, const RunConditions& conditions,
             std::span<const Contender> contenders);

    [[nodiscard]] bool contains(const RunKey& key) const { return rows_.contains(key); }
    [[nodiscard]] std::size_t size() const { return rows_.size(); }
    void add(const RunRecord& record);
    /// Take over the runs of another table that this one lacks.
    void merge(RunTable other) { rows_.merge(other.rows_); }
    [[nodiscard]] std::string csv() const;

  private:
    std::map<RunKey, std::string> rows_;
};

}  // namespace fretwork::optimization::study

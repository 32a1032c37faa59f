// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/studies/run_table.hpp>

#include <algorithm>

namespace fretwork::optimization::study {
namespace {

constexpr int kRecordDigits = 7;

/// The trace, thinned. A point is kept if the remaining gain until the end of the run is at least a fifth
/// less than at the last kept point. So the value at any cost is known up to a fifth of the remaining gain.
std::string thinned(const std::vector<optimization::TracePoint>& trace) {
    constexpr double kShareLeft = 0.8;
    constexpr int kDigits = 12;
    std::string text;
    double left = 0.0;
    for (std::size_t i = 0; i < trace.size(); ++i) {
        const bool is_end = i == 0 || i + 1 == trace.size();
        const double to_gain = trace[i].value - trace.back().value;
        if (!is_end && to_gain > kShareLeft * left) continue;
        left = to_gain;
        text += (text.empty() ? "" : " ") + std::to_string(trace[i].cost) + ":" +
                base::format_number(trace[i].value, kDigits);
    }
    return text;
}

constexpr std::string_view kCommandColumn = ",command";
constexpr std::size_t kCommand = 18;  ///< the column of the command, the last one
constexpr std::size_t kColumns = kCommand + 1;

/// The cells of a line. The command is quoted if it has commas.
std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells = base::split(line, ',');
    if (cells.size() <= kColumns || !cells[kCommand].starts_with('"')) return cells;
    cells[kCommand] = base::join(std::span(cells).subspan(kCommand), ",");
    cells.resize(kColumns);
    return cells;
}

/// A command as a cell, on one line.
std::string command_cell(const std::string& command) {
    return base::csv_field(base::printable(command));
}

std::vector<std::string> ending_names() {
    std::vector<std::string> names;
    for (const Ending ending :
         {Ending::Converged, Ending::BudgetSpent, Ending::Stalled, Ending::Invalid, Ending::Stopped})
        names.emplace_back(ending_name(ending));
    return names;
}

bool is_trace(const std::string& text) {
    const auto is_point = [](const std::string& point) {
        const auto colon = point.find(':');
        return colon != std::string::npos && base::read_number<long>(point.substr(0, colon)) &&
               base::read_number<double>(point.substr(colon + 1));
    };
    return text.empty() || std::ranges::all_of(base::split(text, ' '), is_point);
}

/// The fault of a row of a table; empty if it has none.
std::string row_fault(const std::vector<std::string>& cells) {
    if (cells.size() != kColumns)
        return "has " + std::to_string(cells.size()) + " columns, where " + std::to_string(kColumns) +
               " are needed";
    const auto no_count = [&](std::size_t column) {
        return base::read_number<long>(cells[column]).value_or(-1) < 0;
    };
    if (base::read_number<int>(cells[2]).value_or(0) < 1)
        return "repetition '" + cells[2] + "' is not a number from 1 on";
    static const std::vector<std::string> kEndings = ending_names();
    if (std::ranges::find(kEndings, cells[8]) == kEndings.end())
        return "termination '" + cells[8] + "' is none of " + base::join(kEndings, ", ");
    for (const std::size_t value : {9U, 10U}) {
        if (!base::read_number<double>(cells[value])) return "value '" + cells[value] + "' is not a number";
    }
    for (const std::size_t count : {12U, 13U, 14U, 15U}) {
        if (no_count(count)) return "count '" + cells[count] + "' is not a number from 0 on";
    }
    if (!(base::read_number<double>(cells[16]).value_or(-1.0) >= 0.0))
        return "CPU time '" + cells[16] + "' is not a number from 0 on";
    return is_trace(cells[17]) ? "" : "its trace is not a list of cost:value";
}

/// A message if the command of a row is not the command of its method. Empty if the commands are equal, or if
/// the study does not have the method.
std::string other_command(const std::string& stored, const RunKey& key,
                          std::span<const Contender> contenders) {
    const auto contender = std::ranges::find(contenders, key.optimizer,
                                             [](const Contender& c) { return std::string(c.method->name); });
    if (contender == contenders.end() || stored == command_cell(contender->method->command)) return "";
    constexpr std::size_t kMostShown = 80;
    const std::string what =
        stored.empty() ? "without a command" : "by another command: " + base::shortened(stored, kMostShown);
    return "rows of '" + key.optimizer + "' were made " + what +
           "; choose another name or another output folder";
}

/// The condition in which a row's run differs from the study; empty if all conditions are equal.
std::string other_condition(const std::vector<std::string>& cells, const RunKey& key,
                            const RunConditions& conditions, std::span<const Contender> contenders) {
    const auto contender = std::ranges::find(contenders, key.optimizer,
                                             [](const Contender& c) { return std::string(c.method->name); });
    if (cells[6] != std::to_string(run_seed(key, conditions.seed))) return "seed (or problem, or method)";
    if (cells[7] != std::to_string(conditions.budget.cost)) return "budget, " + cells[7];
    if (contender != contenders.end() && cells[5] != std::to_string(contender->starts))
        return "number of starts, " + cells[5];
    return "";
}

}  // namespace

std::string run_table_header() {
    return "problem,optimizer,repetition,class,dimension,starts,seed,budget,termination,best_value,last_"
           "value,"
           "distance,cost,evaluations,derivative_evaluations,failures,cpu_seconds,trace" +
           std::string(kCommandColumn);
}

bool is_run_table_header(std::string_view line) {
    const std::string header = run_table_header();
    return line == header || line == header.substr(0, header.size() - kCommandColumn.size());
}

std::string run_table_row(const RunRecord& record) {
    const optimization::OptimizationReport& report = record.report;
    const std::vector<std::string> cells = {
        record.key.problem,
        record.key.optimizer,
        std::to_string(record.key.repetition),
        std::string(optimizer_class_name(record.kind)),
        std::to_string(record.dimension),
        std::to_string(record.starts),
        std::to_string(record.seed),
        std::to_string(record.budget),
        std::string(ending_name(report.ending)),
        base::format_number(report.value),
        base::format_number(record.last_value),
        record.distance < 0.0 ? "" : base::format_number(record.distance, kRecordDigits),
        std::to_string(report.cost),
        std::to_string(report.evaluations),
        std::to_string(report.derivative_evaluations),
        std::to_string(report.failures),
        base::format_number(record.cpu_seconds, kRecordDigits),
        thinned(report.trace),
        command_cell(record.command)};
    return base::join(cells, ",");
}

RunTable::RunTable(std::string_view text, const std::string& source, const RunConditions& conditions,
                   std::span<const Contender> contenders) {
    auto lines = base::split_lines(text);
    if (!is_run_table_header(lines.front())) {
        throw base::InputError(source, "line 1",
                               "is not the header of a table of runs: " + run_table_header());
    }
    // Rows of an earlier version lack the last column.
    const std::string_view end = lines.front() == run_table_header() ? "" : ",";
    for (std::size_t i = 1; i < lines.size(); ++i) {
        if (lines[i].empty()) continue;
        const std::string place = "line " + std::to_string(i + 1);
        const std::string line = lines[i].append(end);
        const auto cells = cells_of(line);
        if (const std::string fault = row_fault(cells); !fault.empty())
            throw base::InputError(source, place, fault);
        const RunKey key{cells[0], cells[1], base::read_number<int>(cells[2]).value_or(0)};
        if (const std::string other = other_condition(cells, key, conditions, contenders); !other.empty())
            throw base::InputError(
                source, place,
                "this run was made with another " + other + "; use the same one, or choose another folder");
        if (const std::string other = other_command(cells[kCommand], key, contenders); !other.empty())
            throw base::InputError(source, place, other);
        if (!rows_.emplace(key, line).second)
            throw base::InputError(source, place, "this run stands in the table already");
    }
}

void RunTable::add(const RunRecord& record) {
    rows_[record.key] = run_table_row(record);
}

std::string RunTable::csv() const {
    std::string text = run_table_header() + "\n";
    for (const auto& [key, row] : rows_) text += row + "\n";
    return text;
}

}  // namespace fretwork::optimization::study

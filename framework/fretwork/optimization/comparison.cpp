// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/sha256.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/comparison.hpp>

#include <algorithm>
#include <cstdio>
#include <ctime>

namespace fretwork::optimization {
namespace {

double thread_cpu_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// How many starts a method gets, where it is not one.
struct Starts {
    std::string_view method;
    int starts;
};
constexpr Starts kStarts[] = {
    {"ceres-multistart", 8},
    {"gauss-newton-multistart", 8},
    {"ceres-residuals", 8},
    {"ceres-dogleg", 8},
    {"ceres-subspace-dogleg", 8},
    {"ceres-sine", 8},
    {"ceres-smoothed", 8},
    {"ceres-smoothed-dogleg", 8},
    {"ceres-smoothed-subspace-dogleg", 8},
    {"ceres-smoothed-sine", 8},
    {"bobyqa", 8},
    {"subplex", 4},
    {"slsqp", 16},
    {"cma-es", 4},
};

std::string short_number(double value, int digits = 7) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

/// A point is kept if what the run still has to gain until its end is a fifth less than at the last one: so
/// closely the cost of hitting a target is known, whatever the target.
std::string thinned(const std::vector<TracePoint>& trace) {
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
                short_number(trace[i].value, kDigits);
    }
    return text;
}

double distance_between(const Bounds& bounds, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return (a - b).cwiseQuotient(bounds.upper - bounds.lower).lpNorm<Eigen::Infinity>();
}

constexpr std::size_t kColumns = 18;

bool is_trace(const std::string& text) {
    const auto is_point = [](const std::string& point) {
        const auto colon = point.find(':');
        return colon != std::string::npos && base::read_number<long>(point.substr(0, colon)) &&
               base::read_number<double>(point.substr(colon + 1));
    };
    return text.empty() || std::ranges::all_of(base::split(text, ' '), is_point);
}

/// What is wrong with a row of a table; empty if nothing is.
std::string row_fault(const std::vector<std::string>& cells) {
    if (cells.size() != kColumns)
        return "has " + std::to_string(cells.size()) + " columns, where " + std::to_string(kColumns) +
               " are needed";
    const auto no_count = [&](std::size_t column) {
        return base::read_number<long>(cells[column]).value_or(-1) < 0;
    };
    if (base::read_number<int>(cells[2]).value_or(0) < 1)
        return "repetition '" + cells[2] + "' is no number from 1 on";
    constexpr std::string_view kTerminations[] = {"converged", "budget-spent", "stalled", "invalid"};
    if (std::ranges::find(kTerminations, cells[8]) == std::end(kTerminations))
        return "termination '" + cells[8] + "' is none of converged, budget-spent, stalled, invalid";
    for (const std::size_t value : {9U, 10U}) {
        if (!base::read_number<double>(cells[value])) return "value '" + cells[value] + "' is no number";
    }
    for (const std::size_t count : {12U, 13U, 14U, 15U}) {
        if (no_count(count)) return "count '" + cells[count] + "' is no number from 0 on";
    }
    if (!(base::read_number<double>(cells[16]).value_or(-1.0) >= 0.0))
        return "CPU time '" + cells[16] + "' is no number from 0 on";
    return is_trace(cells[17]) ? "" : "its trace is no list of cost:value";
}

/// Under which other condition a row's run was made; empty if under the same ones.
std::string other_condition(const std::vector<std::string>& cells, const RunKey& key,
                            const ComparisonOptions& options, std::span<const Contender> contenders) {
    const auto contender = std::ranges::find(contenders, key.optimizer,
                                             [](const Contender& c) { return std::string(c.method->name); });
    if (cells[6] != std::to_string(run_seed(key, options.seed))) return "seed (or problem, or method)";
    if (cells[7] != std::to_string(options.budget.cost)) return "budget, " + cells[7];
    if (contender != contenders.end() && cells[5] != std::to_string(contender->starts))
        return "number of starts, " + cells[5];
    return "";
}

}  // namespace

std::vector<Contender> default_contenders() {
    std::vector<Contender> contenders;
    for (const OptimizerRow& row : optimizer_catalogue()) {
        const auto* given = std::ranges::find(kStarts, row.name, &Starts::method);
        contenders.push_back({&row, given == std::end(kStarts) ? 1 : given->starts});
    }
    return contenders;
}

void ComparisonOptions::validate() const {
    budget.validate();
}

std::uint64_t run_seed(const RunKey& key, std::uint64_t comparison_seed) {
    const std::string hash = base::sha256(std::to_string(comparison_seed) + "|" + key.problem + "|" +
                                          key.optimizer + "|" + std::to_string(key.repetition));
    return std::stoull(hash.substr(0, 16), nullptr, 16);
}

RunRecord record_run(const Problem& problem, const Contender& contender, const RunKey& key,
                     const ComparisonOptions& options, const Eigen::VectorXd& optimum) {
    RunRecord record;
    record.key = key;
    record.dimension = problem.bounds().dimension();
    record.kind = contender.method->kind;
    record.starts = contender.starts;
    record.seed = run_seed(key, options.seed);
    record.budget = options.budget.cost;
    const double begin = thread_cpu_seconds();
    record.report = minimize(problem, *contender.method, {.starts = contender.starts, .seed = record.seed},
                             options.budget);
    record.cpu_seconds = thread_cpu_seconds() - begin;
    const bool has_last = problem.bounds().contain(record.report.final_point);
    record.last_value = has_last ? problem.value(record.report.final_point) : record.report.value;
    if (optimum.size() > 0 && record.report.point.size() > 0) {
        record.distance = distance_between(problem.bounds(), record.report.point, optimum);
    }
    return record;
}

int repetitions_of(const Contender& contender, int wanted) {
    return contender.method->kind == OptimizerClass::Global ? 1 : wanted;
}

std::string comparison_header() {
    return "problem,optimizer,repetition,class,dimension,starts,seed,budget,termination,best_value,last_"
           "value,"
           "distance,cost,evaluations,derivative_evaluations,failures,cpu_seconds,trace";
}

std::string comparison_row(const RunRecord& record) {
    const OptimizationReport& report = record.report;
    const std::vector<std::string> cells = {record.key.problem,
                                            record.key.optimizer,
                                            std::to_string(record.key.repetition),
                                            std::string(optimizer_class_name(record.kind)),
                                            std::to_string(record.dimension),
                                            std::to_string(record.starts),
                                            std::to_string(record.seed),
                                            std::to_string(record.budget),
                                            std::string(termination_name(report.termination)),
                                            base::format_number(report.value),
                                            base::format_number(record.last_value),
                                            record.distance < 0.0 ? "" : short_number(record.distance),
                                            std::to_string(report.cost),
                                            std::to_string(report.evaluations),
                                            std::to_string(report.derivative_evaluations),
                                            std::to_string(report.failures),
                                            short_number(record.cpu_seconds),
                                            thinned(report.trace)};
    return base::join(cells, ",");
}

ComparisonTable::ComparisonTable(std::string_view text, const std::string& source,
                                 const ComparisonOptions& options, std::span<const Contender> contenders) {
    const auto lines = base::split(text, '\n');
    if (lines.front() != comparison_header()) {
        throw base::InputError(source, "line 1",
                               "is not the header of a table of runs: " + comparison_header());
    }
    for (std::size_t i = 1; i < lines.size(); ++i) {
        if (lines[i].empty()) continue;
        const std::string place = "line " + std::to_string(i + 1);
        const auto cells = base::split(lines[i], ',');
        if (const std::string fault = row_fault(cells); !fault.empty())
            throw base::InputError(source, place, fault);
        const RunKey key{cells[0], cells[1], base::read_number<int>(cells[2]).value_or(0)};
        if (const std::string other = other_condition(cells, key, options, contenders); !other.empty())
            throw base::InputError(
                source, place,
                "this run was made with another " + other + "; choose another folder, or the same one");
        if (!rows_.emplace(key, lines[i]).second)
            throw base::InputError(source, place, "this run stands in the table already");
    }
}

void ComparisonTable::add(const RunRecord& record) {
    rows_[record.key] = comparison_row(record);
}

std::string ComparisonTable::csv() const {
    std::string text = comparison_header() + "\n";
    for (const auto& [key, row] : rows_) text += row + "\n";
    return text;
}

}  // namespace fretwork::optimization

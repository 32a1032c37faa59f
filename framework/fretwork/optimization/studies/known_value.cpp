// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/task.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/sampling.hpp>
#include <fretwork/optimization/studies/known_value.hpp>
#include <fretwork/optimization/studies/run_table.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fretwork::optimization::study {
namespace {

/// The seed of the search for known values. It differs from the seeds of runs, which are hashes.
constexpr std::uint64_t kReferenceSeed = 1'000'003;
constexpr const char* kKnownHeader = "problem,best_value,scale,found_by";

double median_value(const optimization::Problem& problem) {
    constexpr int kPoints = 1001;
    const optimization::LowDiscrepancySequence sequence(problem.bounds().dimension(), kReferenceSeed);
    std::vector<double> values;
    for (int i = 0; i < kPoints; ++i) {
        values.push_back(problem.value(problem.bounds().at_shares(sequence.point(i))));
    }
    std::ranges::nth_element(values, values.begin() + kPoints / 2);
    return values[kPoints / 2];
}

KnownValue find_known_value(const std::string& id, const KnownValueOptions& options) {
    const StudyProblem entry = make_study_problem(id, options.families);
    if (entry.best_value) {
        const double scale = entry.scale ? *entry.scale : median_value(*entry.problem) - *entry.best_value;
        return {id, *entry.best_value, scale, "construction"};
    }
    KnownValue known{id, 0.0, 0.0, ""};
    for (const char* name : {"ceres-multistart", "gauss-newton-multistart"}) {
        const auto report =
            minimize(*entry.problem, optimization::find_optimizer(name),
                     {.starts = options.starts, .seed = kReferenceSeed},
                     {.cost = std::numeric_limits<long>::max() / 2, .control = options.control.silent()});
        if (!known.found_by.empty() && report.value >= known.best_value) continue;
        known.best_value = report.value;
        known.found_by = std::string(name) + " with " + std::to_string(options.starts) + " starts";
    }
    known.scale = entry.scale.value_or(known.best_value);
    return known;
}

KnownValue read_known_value(const std::vector<std::string>& cells, const std::string& file,
                            const std::string& place) {
    const auto value = base::read_number<double>(cells[1]);
    const auto scale = base::read_number<double>(cells[2]);
    if (!value || !std::isfinite(*value))
        throw base::InputError(file, place, "best_value '" + cells[1] + "' is not a finite number");
    if (!scale || !std::isfinite(*scale) || *scale <= 0.0)
        throw base::InputError(file, place, "scale '" + cells[2] + "' is not a finite number above zero");
    return {cells[0], *value, *scale, cells[3]};
}

}  // namespace

std::vector<KnownValue> read_known_values(const std::filesystem::path& path) {
    const auto lines = base::split_lines(base::read_text_file(path));
    if (lines.front() != kKnownHeader) {
        throw base::InputError(path.string(), "line 1", std::string("must be the header ") + kKnownHeader);
    }
    std::vector<KnownValue> values;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        if (lines[i].empty()) continue;
        const auto cells = base::split(lines[i], ',');
        if (cells.size() != 4) {
            throw base::InputError(path.string(), "line " + std::to_string(i + 1),
                                   "'" + lines[i] + "' must have 4 columns: " + kKnownHeader);
        }
        values.push_back(read_known_value(cells, path.string(), "line " + std::to_string(i + 1)));
        if (std::ranges::count(values, cells[0], &KnownValue::problem) > 1)
            throw base::InputError(path.string(), "line " + std::to_string(i + 1),
                                   "problem " + cells[0] + " stands in the file already");
    }
    return values;
}

std::string known_values_csv(const std::vector<KnownValue>& values) {
    std::string text = std::string(kKnownHeader) + "\n";
    for (const KnownValue& value : values) {
        text += value.problem + "," + base::format_number(value.best_value) + "," +
                base::format_number(value.scale) + "," + value.found_by + "\n";
    }
    return text;
}

void KnownValueOptions::validate() const {
    if (starts < 1) throw base::InputError("starts: " + std::to_string(starts) + " must be at least 1");
}

std::vector<KnownValue> find_known_values(const std::vector<std::string>& problems,
                                          const KnownValueOptions& options) {
    options.validate();
    std::vector<KnownValue> values(problems.size());
    base::ParallelTask task(options.control, "best known values", problems.size());
    base::parallel_for(problems.size(), options.threads, [&](std::size_t i) {
        options.control.check();
        values[i] = find_known_value(problems[i], options);
        task.advance();
    });
    return values;
}

void improve_known_values(std::vector<KnownValue>& values, const std::filesystem::path& results) {
    constexpr double kRoundOff = 1e-9;
    const auto lines = base::split_lines(base::read_text_file(results));
    if (!is_run_table_header(lines.front())) {
        throw base::InputError(results.string(), "line 1", "is not the header of a table of runs");
    }
    for (std::size_t i = 1; i < lines.size(); ++i) {
        if (lines[i].empty()) continue;
        const auto cells = base::split(lines[i], ',');
        const auto value = std::ranges::find(values, cells[0], &KnownValue::problem);
        if (value == values.end() || value->found_by == "construction") continue;
        const double found = cells.size() > 9 ? base::read_number<double>(cells[9]).value_or(-1.0) : -1.0;
        if (!(found >= 0.0))
            throw base::InputError(results.string(), "line " + std::to_string(i + 1),
                                   "best_value is not a number that is 0 or larger");
        if (found >= value->best_value * (1.0 - kRoundOff)) continue;
        const double scale = value->scale == value->best_value ? found : value->scale;
        *value = {cells[0], found, scale, cells[1] + " in repetition " + cells[2] + " of the comparison"};
    }
}

}  // namespace fretwork::optimization::study

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/library/statistics.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fretwork::library {
namespace {

void describe(std::vector<double> objectives, CalibrationStatistics& result) {
    if (objectives.empty()) return;
    const auto count = static_cast<double>(objectives.size());
    result.mean = std::accumulate(objectives.begin(), objectives.end(), 0.0) / count;
    double squares = 0.0;
    for (const double value : objectives) squares += (value - result.mean) * (value - result.mean);
    result.deviation = std::sqrt(squares / count);
    std::ranges::sort(objectives);
    const std::size_t half = objectives.size() / 2;
    result.median =
        objectives.size() % 2 == 1 ? objectives[half] : (objectives[half - 1] + objectives[half]) / 2.0;
}

}  // namespace

CalibrationStatistics calibration_statistics(const Library& library, std::span<const PatternEntry> patterns,
                                             const CalibrationKey& key) {
    std::map<std::string, PatternSummary> summaries;
    for (PatternSummary& summary : library.summaries())
        summaries.emplace(summary.pattern, std::move(summary));
    CalibrationStatistics result;
    std::vector<double> objectives;
    for (const PatternEntry& entry : patterns) {
        for (const CalibrationRecord& record : library.calibrations(entry.id)) {
            if (record.key() != key) continue;
            objectives.push_back(record.calibration.objective);
            for (const std::string& name : record.calibration.at_bound) ++result.at_bound[name];
            const PatternSummary& summary = summaries.at(entry.id);
            result.samples += static_cast<std::size_t>(summary.samples);
            result.converged += static_cast<std::size_t>(summary.converged_samples);
            result.limit_load += static_cast<std::size_t>(summary.limit_load_samples);
            result.unstable += static_cast<std::size_t>(summary.converged_samples - summary.stable_samples);
        }
    }
    result.calibrated = objectives.size();
    describe(std::move(objectives), result);
    return result;
}

}  // namespace fretwork::library

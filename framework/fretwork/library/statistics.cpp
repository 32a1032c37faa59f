// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/library/statistics.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace fretwork::library {
namespace {

double median_of(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2.0;
}

void describe(std::vector<double> objectives, CalibrationStatistics& result) {
    if (objectives.empty()) return;
    const auto count = static_cast<double>(objectives.size());
    result.mean = std::accumulate(objectives.begin(), objectives.end(), 0.0) / count;
    double squares = 0.0;
    for (const double value : objectives) squares += (value - result.mean) * (value - result.mean);
    result.deviation = std::sqrt(squares / count);
    result.median = median_of(std::move(objectives));
}

}  // namespace

double far_above_limit(std::vector<double> objectives) {
    constexpr std::size_t kFewest = 20;
    constexpr double kDeviations = 4.0;
    constexpr double kLeastRatio = 10.0;
    // Ratio of the standard deviation of a normal distribution to its median absolute deviation.
    constexpr double kDeviationOfNormal = 1.4826;
    if (objectives.size() < kFewest) return std::numeric_limits<double>::infinity();
    const double median = median_of(objectives);
    if (!(median > 0.0)) return std::numeric_limits<double>::infinity();
    for (double& value : objectives)
        value = std::abs(std::log(std::max(value, std::numeric_limits<double>::min()) / median));
    const double deviation = kDeviationOfNormal * median_of(std::move(objectives));
    return median * std::max(kLeastRatio, std::exp(kDeviations * deviation));
}

CalibrationStatistics calibration_statistics(const Library& library,
                                             std::span<const pattern::NamedPattern> patterns,
                                             const CalibrationKey& key) {
    const std::vector<PatternSummary> summaries = library.summaries(patterns);
    CalibrationStatistics result;
    result.far_above_limit = far_above_limit(library.objectives(key));
    std::vector<double> objectives;
    for (const PatternSummary& summary : summaries) {
        if (summary.calibrations == 0) continue;
        for (const CalibrationRecord& record : library.calibrations(summary.pattern)) {
            if (record.key() != key) continue;
            objectives.push_back(record.calibration.objective);
            if (objectives.back() > result.far_above_limit)
                result.far_above.push_back({summary.pattern, objectives.back()});
            for (const std::string& name : record.calibration.at_bound) ++result.at_bound[name];
            result.samples += summary.samples;
            result.converged += summary.converged_samples;
            result.limit_load += summary.limit_load_samples;
            result.unstable += summary.converged_samples - summary.stable_samples;
        }
    }
    result.calibrated = objectives.size();
    describe(std::move(objectives), result);
    return result;
}

}  // namespace fretwork::library

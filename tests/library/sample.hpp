// SPDX-License-Identifier: GPL-3.0-or-later
// Patterns and made-up values to fill libraries with.
#pragma once

#include "support.hpp"

#include <fretwork/library/library.hpp>

#include <cmath>
#include <set>

namespace fretwork::library::test {

using fretwork::test::complaint_of;
using fretwork::test::TemporaryFolder;

inline const pattern::NodeLayout& paper_layout() {
    static const pattern::NodeLayout layout = pattern::find_node_layout("paper7");
    return layout;
}

inline std::vector<pattern::Pattern> parse(const std::vector<std::string>& ids) {
    std::vector<pattern::Pattern> patterns;
    for (const std::string& id : ids) patterns.push_back(pattern::parse_pattern_id(paper_layout(), id));
    return patterns;
}

inline const std::vector<std::string>& sample_ids() {
    static const std::vector<std::string> ids = {"0-1+1-6", "1-6+3-6", "0-6+1-6+3-6", "0-1+1-5+5-6+3-6"};
    return ids;
}

/// Values that need all digits of a double, different for each pattern.
inline std::vector<reduction::Response> sample_responses(const reduction::Setting& setting, double seed) {
    std::vector<reduction::Response> responses;
    for (const reduction::Scenario& scenario : setting.scenarios) {
        reduction::Response response{scenario.name, {}};
        for (int k = 1; k <= setting.magnitudes; ++k) {
            reduction::Response::Sample sample{k, scenario.max_magnitude * k / setting.magnitudes,
                                               mechanics::NodeValues(6, 6)};
            for (int i = 0; i < 36; ++i)
                sample.displacements(i / 6, i % 6) = i % 5 == 0 ? 0.0 : std::sin(seed + i) * k / 3.0 * 1e-3;
            sample.stable = k < 9;
            sample.discretization_error = 1e-5 * k / 3.0;
            if (k == setting.magnitudes) {
                sample.converged = false;
                sample.limit_load = true;
                sample.discretization_error.reset();
                sample.displacements.setZero();
            }
            response.samples.push_back(sample);
        }
        responses.push_back(response);
    }
    return responses;
}

inline CalibrationRecord sample_calibration(double objective, std::uint64_t seed = 1) {
    CalibrationRecord record;
    record.calibration.optimizer = "ceres-multistart";
    record.calibration.seed = seed;
    record.calibration.starts = 8;
    record.calibration.objective = objective;
    record.calibration.scenario_errors = {0.1, 0.2, 1.0 / 3.0, 0.4, 0.5};
    record.calibration.cost = 1234;
    record.calibration.model = "paper6";
    record.calibration.parameters = {{"A", 4e-6},     {"I2", 1.0 / 3e12}, {"I3", 1.3e-12},
                                     {"J", 2.25e-12}, {"R", 0.012},       {"theta", -0.1}};
    record.calibration.at_bound = {"A", "theta"};
    record.budget = 20000;
    record.seconds = 0.25;
    return record;
}

inline PatternData sample_data(const std::string& id, double seed) {
    return {id,
            sample_responses(reduction::paper_setting(), seed),
            {sample_calibration(1.0 / seed)},
            {{"mass_per_area", seed / 3.0}}};
}

inline Library make_library(const std::filesystem::path& path,
                            const std::vector<std::string>& ids = sample_ids()) {
    Library library = Library::create(path, paper_layout(), reduction::paper_setting());
    library.add_patterns(parse(ids));
    return library;
}

inline std::vector<std::string> ids_of(const std::vector<pattern::NamedPattern>& entries) {
    std::vector<std::string> ids;
    for (const pattern::NamedPattern& entry : entries) ids.push_back(entry.id);
    return ids;
}

/// The folder's files, by name.
inline std::vector<std::pair<std::string, std::string>> folder_content(const std::filesystem::path& folder) {
    std::set<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) paths.insert(entry.path());
    std::vector<std::pair<std::string, std::string>> content;
    for (const auto& path : paths) content.emplace_back(path.filename(), base::read_text_file(path));
    return content;
}

}  // namespace fretwork::library::test

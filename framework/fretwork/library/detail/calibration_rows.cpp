// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/library/detail/rows.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fretwork::library::detail {
namespace {

using reduction::Calibration;

constexpr std::string_view kColumns =
    "model, optimizer, seed, starts, budget, objective, evaluations, converged, at_bound, seconds";
constexpr std::string_view kOfOne =
    " WHERE pattern_id = ? AND model = ? AND optimizer = ? AND seed = ? AND starts = ? AND budget = ?";

bool has_only_finite_values(const CalibrationRecord& record) {
    const Calibration& calibration = record.calibration;
    const auto finite = [](double value) { return std::isfinite(value); };
    return finite(calibration.objective) && finite(record.seconds) &&
           std::ranges::all_of(calibration.parameters, finite, &reduction::NamedValue::value) &&
           std::ranges::all_of(calibration.scenario_errors, finite);
}

/// Bind the key of a calibration, then further values.
template <class... Values>
Statement& bind_of_one(Statement& statement, std::string_view pattern_id, const CalibrationKey& key,
                       const Values&... more) {
    return statement.bind_all(pattern_id, key.model, key.optimizer, static_cast<std::int64_t>(key.seed),
                              key.starts, key.budget, more...);
}

CalibrationRecord read_row(const Statement& row) {
    CalibrationRecord record;
    Calibration& calibration = record.calibration;
    calibration.model = row.text(0);
    calibration.optimizer = row.text(1);
    calibration.seed = row.integer(2);
    calibration.starts = row.count(3);
    record.budget = row.count(4);
    calibration.objective = row.real(5);
    calibration.cost = row.integer(6);
    calibration.converged = row.integer(7) != 0;
    if (!row.text(8).empty()) calibration.at_bound = base::split(row.text(8), ',');
    record.seconds = row.real(9);
    return record;
}

void read_errors(const Database& database, std::string_view pattern_id, const reduction::Setting& setting,
                 CalibrationRecord& record) {
    Statement statement(database,
                        "SELECT error FROM calibration_error" + std::string(kOfOne) + " AND scenario = ?");
    const CalibrationKey key = record.key();
    for (const reduction::Scenario& scenario : setting.scenarios) {
        bind_of_one(statement, pattern_id, key, scenario.name);
        if (statement.step()) record.calibration.scenario_errors.push_back(statement.real(0));
    }
}

void read_parameters(const Database& database, std::string_view pattern_id, CalibrationRecord& record) {
    Statement statement(
        database, "SELECT name, value FROM calibration_parameter" + std::string(kOfOne) + " ORDER BY name");
    bind_of_one(statement, pattern_id, record.key());
    while (statement.step())
        record.calibration.parameters.push_back({std::string(statement.text(0)), statement.real(1)});
}

void insert_errors(const Database& database, const std::string& pattern_id, const CalibrationRecord& record,
                   const reduction::Setting& setting) {
    Statement statement(database, "INSERT INTO calibration_error VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
    const std::vector<double>& errors = record.calibration.scenario_errors;
    for (std::size_t k = 0; k < errors.size(); ++k)
        bind_of_one(statement, pattern_id, record.key(), setting.scenarios[k].name, errors[k]).run();
}

void insert_parameters(const Database& database, const std::string& pattern_id,
                       const CalibrationRecord& record) {
    Statement statement(database, "INSERT INTO calibration_parameter VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
    for (const auto& [name, value] : record.calibration.parameters)
        bind_of_one(statement, pattern_id, record.key(), name, value).run();
}

std::vector<reduction::NamedValue> sorted(std::vector<reduction::NamedValue> parameters) {
    std::ranges::sort(parameters, {}, &reduction::NamedValue::name);
    return parameters;
}

}  // namespace

void check_calibration(const Database& database, const std::string& pattern_id,
                       const CalibrationRecord& record, const reduction::Setting& setting) {
    const std::string file = database.path().string();
    const std::string place = "calibration of " + pattern_id;
    const Calibration& calibration = record.calibration;
    if (calibration.seed > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()))
        throw base::InputError(
            file, place,
            "has the seed " + std::to_string(calibration.seed) + ", where one below 2^63 is needed");
    const std::size_t errors = calibration.scenario_errors.size();
    if (errors != 0 && errors != setting.scenarios.size())
        throw base::InputError(file, place,
                               "has " + std::to_string(errors) + " errors, where the setting has " +
                                   std::to_string(setting.scenarios.size()) + " scenarios");
    if (!has_only_finite_values(record))
        throw base::NumericalError(file + ": " + place + ": a value is not finite");
}

void insert_calibration(const Database& database, const std::string& pattern_id,
                        const CalibrationRecord& record, const reduction::Setting& setting) {
    Statement statement(database, "INSERT INTO calibration (pattern_id, " + std::string(kColumns) +
                                      ") VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    const Calibration& c = record.calibration;
    bind_of_one(statement, pattern_id, record.key(), c.objective, static_cast<std::int64_t>(c.cost),
                int{c.converged}, base::join(c.at_bound, ","), record.seconds)
        .run();
    insert_parameters(database, pattern_id, record);
    insert_errors(database, pattern_id, record, setting);
}

std::vector<CalibrationRecord> read_calibrations(const Database& database, std::string_view pattern_id,
                                                 const reduction::Setting& setting) {
    Statement statement(database, "SELECT " + std::string(kColumns) +
                                      " FROM calibration WHERE pattern_id = ? "
                                      "ORDER BY model, optimizer, seed, starts, budget");
    statement.bind_all(pattern_id);
    std::vector<CalibrationRecord> records;
    while (statement.step()) records.push_back(read_row(statement));
    for (CalibrationRecord& record : records) {
        read_parameters(database, pattern_id, record);
        read_errors(database, pattern_id, setting, record);
    }
    return records;
}

bool are_equal(const CalibrationRecord& left, const CalibrationRecord& right) {
    const Calibration& a = left.calibration;
    const Calibration& b = right.calibration;
    return left.key() == right.key() && a.objective == b.objective &&
           a.scenario_errors == b.scenario_errors && a.cost == b.cost &&
           sorted(a.parameters) == sorted(b.parameters) && a.at_bound == b.at_bound &&
           a.converged == b.converged;
}

}  // namespace fretwork::library::detail

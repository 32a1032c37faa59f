// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/detail/database.hpp>
#include <fretwork/library/library.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace fretwork::library::detail {

/// Throw InputError or NumericalError, with the pattern's name, unless the record can be stored: a key that
/// SQLite can hold, finite values, no error or one for each scenario of the setting.
void check_calibration(const Database& database, const std::string& pattern_id,
                       const CalibrationRecord& record, const reduction::Setting& setting);

/// Insert a record that passed check_calibration.
void insert_calibration(const Database& database, const std::string& pattern_id,
                        const CalibrationRecord& record, const reduction::Setting& setting);

/// All calibrations of a pattern, sorted by key; their parameters by name.
std::vector<CalibrationRecord> read_calibrations(const Database& database, std::string_view pattern_id,
                                                 const reduction::Setting& setting);

/// True if two records of one key are equal, except for the time that they took.
bool are_equal(const CalibrationRecord& left, const CalibrationRecord& right);

}  // namespace fretwork::library::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/detail/database.hpp>
#include <fretwork/library/library.hpp>
#include <fretwork/reduction/response.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace fretwork::library::detail {

/// The shape of a library's responses: the same for all of its patterns.
struct ResponseShape {
    const reduction::Setting* setting;
    int nodes;  ///< interface nodes of a tile
};

/// Throw InputError or NumericalError, with the pattern's name, unless there is one response for each
/// scenario of the setting, with all samples and rows, and all values are finite.
void check_responses(const Database& database, const std::string& pattern_id,
                     const std::vector<reduction::Response>& responses, const ResponseShape& shape);

/// Insert responses that passed check_responses. Samples that did not converge have a state and no rows of
/// displacements.
void insert_responses(const Database& database, const std::string& pattern_id,
                      const std::vector<reduction::Response>& responses);

/// Reads responses, pattern by pattern; each statement is prepared once.
class ResponseReader {
  public:
    ResponseReader(const Database& database, const ResponseShape& shape);
    /// The responses of a pattern in the order of the setting's scenarios; empty if they are not there.
    /// Throws InputError if a row is of no state.
    std::vector<reduction::Response> read(std::string_view pattern_id);

  private:
    void read_states(std::string_view pattern_id, std::vector<reduction::Response>& responses);
    void read_displacements(std::string_view pattern_id, std::vector<reduction::Response>& responses);

    const Database& database_;
    ResponseShape shape_;
    Statement states_;
    Statement displacements_;
};

/// True if all values are equal.
bool are_equal(const std::vector<reduction::Response>& left, const std::vector<reduction::Response>& right);

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

/// Record this writer: the program's provenance, the host and the time, under the next session number.
void record_writer(const Database& database);

}  // namespace fretwork::library::detail

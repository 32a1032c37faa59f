// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/detail/database.hpp>
#include <fretwork/library/library.hpp>
#include <fretwork/reduction/response.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace fretwork::library::detail {

/// The shape that the responses of all patterns of a library have.
struct ResponseShape {
    const reduction::Setting* setting;
    int nodes;  ///< number of interface nodes of a tile
};

/// Check that a pattern has one response for each scenario of the setting, with all samples and rows, and
/// that all values are finite. Throws InputError or NumericalError that names the pattern.
void check_responses(const Database& database, const std::string& pattern_id,
                     const std::vector<reduction::Response>& responses, const ResponseShape& shape);

/// Insert responses that passed check_responses. Samples that did not converge have a state and no rows of
/// displacements.
void insert_responses(const Database& database, const std::string& pattern_id,
                      const std::vector<reduction::Response>& responses);

/// A reader of the responses of many patterns, which prepares each statement once.
class ResponseReader {
  public:
    ResponseReader(const Database& database, const ResponseShape& shape);
    /// The responses of a pattern in the order of the setting's scenarios; empty if none are stored. Throws
    /// InputError if a row belongs to no stored state or to no interface node.
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

/// Check that a record can be stored: SQLite can hold its key, its values are finite, and it has no scenario
/// errors or one for each scenario of the setting. Throws InputError or NumericalError that names the
/// pattern.
void check_calibration(const Database& database, const std::string& pattern_id,
                       const CalibrationRecord& record, const reduction::Setting& setting);

/// Insert a record that passed check_calibration.
void insert_calibration(const Database& database, const std::string& pattern_id,
                        const CalibrationRecord& record, const reduction::Setting& setting);

/// All calibrations of a pattern, sorted by key; the parameters of each are sorted by name.
std::vector<CalibrationRecord> read_calibrations(const Database& database, std::string_view pattern_id,
                                                 const reduction::Setting& setting);

/// True if two records of one key are equal, except for their wall times.
bool are_equal(const CalibrationRecord& left, const CalibrationRecord& right);

/// Record the writer: the provenance of the program, the host and the time, under the next session number.
void record_writer(const Database& database);

}  // namespace fretwork::library::detail

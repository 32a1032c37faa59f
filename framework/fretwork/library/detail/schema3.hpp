// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/detail/database.hpp>

#include <string>

namespace fretwork::library::detail {

// Libraries of schema 3 have the paper's six parameters as columns of `calibration`, and zeros there for
// models without parameters. They are read as they are, and changed to schema 4 when they are opened for
// writing.

/// The rows of schema 4's table calibration_parameter, as a query of a schema-3 database of this name
/// ("main", or as it was attached).
std::string schema3_parameters(const std::string& database_name);

/// Make a temporary view, so that a schema-3 file that is only read answers the queries of schema 4.
void view_schema3(Database& database);

/// Change the tables of a schema-3 file to those of schema 4, all of them or none. Does nothing if another
/// process has done so meanwhile.
void migrate_schema3(Database& database);

/// A query of the calibrations with the columns of schema 3, for content hashes as programs of schema 3 made
/// them. The query works on databases of schema 3 and 4.
std::string schema3_calibrations();

}  // namespace fretwork::library::detail

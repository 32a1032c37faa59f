// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/detail/database.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::library::detail {

/// The application id in the header of a library file: "FRWK".
inline constexpr std::int64_t kApplicationId = 0x4652574B;
/// The version of the schema, raised with every change of the tables.
inline constexpr std::int64_t kSchemaVersion = 4;
/// The oldest version that can be read (see schema3.hpp). Older files are refused.
inline constexpr std::int64_t kOldestSchemaVersion = 3;

/// A table whose rows are content, which is hashed, merged and exported. Provenance is not content.
struct Table {
    std::string_view name;
    std::vector<std::string_view> keys;    ///< the primary key
    std::vector<std::string_view> values;  ///< columns that must be equal in two rows with one key
    /// Columns of times, which are stored but not hashed, compared or exported.
    std::vector<std::string_view> incidental;
};

/// All tables of content. A table that refers to another table comes after it.
std::span<const Table> content_tables();

/// The query of the view `behaviour`. Files have this view for other programs; this program never reads the
/// views of a file.
std::string behaviour_query();

/// The names of the columns of content, keys first, joined by ", ".
std::string content_columns(const Table& table);

/// Make the tables in an empty file, and write the header fields.
void create_schema(Database& database);
/// Make the table calibration_parameter, which schema 3 lacks.
void create_parameter_table(Database& database);
/// The version in the header of a database ("main", or as it was attached).
std::int64_t schema_version(const Database& database, const std::string& database_name = "main");
/// Write kSchemaVersion into the header.
void set_schema_version(Database& database);
/// Throw InputError unless the file is a library of a version that can be read.
void check_schema(const Database& database);
/// True if nothing has ever been stored in the file.
bool is_empty(const Database& database);

}  // namespace fretwork::library::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/detail/database.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::library::detail {

/// "FRWK": what the header of a library file says that it is.
inline constexpr std::int64_t kApplicationId = 0x4652574B;
/// Rises with every change of the tables.
inline constexpr std::int64_t kSchemaVersion = 4;
/// Older files are refused; those from here on are read (see schema3.hpp).
inline constexpr std::int64_t kOldestSchemaVersion = 3;

/// A table whose rows are content: they are hashed, merged and exported. (Provenance is no content.)
struct Table {
    std::string_view name;
    std::vector<std::string_view> keys;        ///< the primary key
    std::vector<std::string_view> values;      ///< what two rows of one key must agree in
    std::vector<std::string_view> incidental;  ///< times: stored, and neither hashed, compared nor exported
};

/// All tables of content; one that refers to another comes after it.
std::span<const Table> content_tables();

/// The rows of the view `behaviour`, which is for other programs: a file's own views are never read.
std::string behaviour_query();

/// Joined by ", ": the keys, then the values.
std::string content_columns(const Table& table);

/// Make the tables in an empty file, and write the header fields.
void create_schema(Database& database);
/// The part of create_schema that schema 3 lacks.
void create_parameter_table(Database& database);
/// The version in the header of a database ("main", or as it was attached).
std::int64_t schema_version(const Database& database, const std::string& database_name = "main");
/// Write this version into the header.
void set_schema_version(Database& database);
/// Throw InputError unless the file is a library of a version that can be read.
void check_schema(const Database& database);
/// True if nothing has ever been stored in the file.
bool is_empty(const Database& database);

}  // namespace fretwork::library::detail

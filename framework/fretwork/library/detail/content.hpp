// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/detail/database.hpp>

#include <filesystem>
#include <string>

namespace fretwork::library::detail {

/// The SHA-256 of all rows of content, sorted by their keys; the setting without its strength and section
/// shape. Each value is hashed as its type, its length if it is a text, and its bytes.
std::string content_hash(Database& database);
/// The content hash as it was computed for tables of schema 3.
std::string schema3_content_hash(Database& database);

/// Write layout.json, setting.json, and one CSV file for each other table of content and for the view
/// `behaviour`.
void export_csv(Database& database, const std::filesystem::path& folder);

}  // namespace fretwork::library::detail

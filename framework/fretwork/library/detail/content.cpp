// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/files/sha256.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/library/detail/content.hpp>
#include <fretwork/library/detail/schema.hpp>
#include <fretwork/library/detail/schema3.hpp>
#include <fretwork/reduction/scenarios/setting_file.hpp>

#include <bit>
#include <system_error>

namespace fretwork::library::detail {
namespace {

std::string sorted_rows_query(const Table& table) {
    const std::vector<std::string> keys(table.keys.begin(), table.keys.end());
    return "SELECT " + content_columns(table) + " FROM " + std::string(table.name) + " ORDER BY " +
           base::join(keys, ", ");
}

/// Hash a number with its least significant byte first, on every machine.
void update(base::Sha256& hash, std::uint64_t number) {
    std::string bytes;
    for (int byte = 0; byte < 8; ++byte) bytes += static_cast<char>(number >> (8 * byte) & 0xffU);
    hash.update(bytes);
}

void update(base::Sha256& hash, std::string_view text) {
    update(hash, text.size());
    hash.update(text);
}

void update(base::Sha256& hash, const Statement& row, int column) {
    switch (row.type(column)) {
        case SQLITE_INTEGER:
            hash.update("i");
            return update(hash, static_cast<std::uint64_t>(row.integer(column)));
        case SQLITE_FLOAT:
            hash.update("r");
            return update(hash, std::bit_cast<std::uint64_t>(row.real(column)));
        default:
            hash.update("t");
            return update(hash, row.text(column));
    }
}

void update(base::Sha256& hash, const Database& database, std::string_view table, const std::string& query) {
    update(hash, table);
    Statement rows(database, query);
    while (rows.step()) {
        for (int column = 0; column < rows.column_count(); ++column) update(hash, rows, column);
    }
}

/// Hash the setting like a table, but without the data that only stresses depend on.
void update_setting(base::Sha256& hash, const Database& database) {
    update(hash, "setting");
    Statement row(database, "SELECT id, json FROM setting");
    if (!row.step()) return;
    update(hash, row, 0);
    const reduction::Setting setting = reduction::parse_setting(row.text(1), "setting");
    hash.update("t");
    update(hash, setting.strength || setting.section.shape
                     ? reduction::setting_text(reduction::without_stresses(setting))
                     : std::string(row.text(1)));
}

std::string csv_cell(const Statement& row, int column) {
    switch (row.type(column)) {
        case SQLITE_INTEGER:
            return std::to_string(row.integer(column));
        case SQLITE_FLOAT:
            return base::format_number(row.real(column));
        default:
            return base::csv_field(row.text(column));
    }
}

void write_csv(const Database& database, const std::string& query, const std::filesystem::path& path) {
    base::AtomicFile file(path);
    Statement rows(database, query);
    for (int column = 0; column < rows.column_count(); ++column)
        file.write((column > 0 ? "," : "") + rows.column_name(column));
    file.write("\n");
    while (rows.step()) {
        for (int column = 0; column < rows.column_count(); ++column) {
            if (column > 0) file.write(",");
            file.write(csv_cell(rows, column));
        }
        file.write("\n");
    }
    file.commit();
}

void write_json(const Database& database, const std::string& table, const std::filesystem::path& folder) {
    Statement row(database, "SELECT json FROM " + table);
    if (row.step()) base::write_file_atomically(folder / (table + ".json"), row.text(0));
}

bool is_json_table(const Table& table) {
    return table.name == "layout" || table.name == "setting";
}

}  // namespace

std::string content_hash(Database& database) {
    const Transaction snapshot(database, Transaction::Kind::Read);
    base::Sha256 hash;
    for (const Table& table : content_tables()) {
        if (table.name == "setting")
            update_setting(hash, database);
        else
            update(hash, database, table.name, sorted_rows_query(table));
    }
    return hash.hexadecimal();
}

std::string schema3_content_hash(Database& database) {
    const Transaction snapshot(database, Transaction::Kind::Read);
    base::Sha256 hash;
    for (const Table& table : content_tables()) {
        if (table.name == "calibration_parameter") continue;
        update(hash, database, table.name,
               table.name == "calibration" ? schema3_calibrations() : sorted_rows_query(table));
    }
    return hash.hexadecimal();
}

void export_csv(Database& database, const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw base::IoError(folder.string(), "", "cannot be made: " + error.message());
    const Transaction snapshot(database, Transaction::Kind::Read);
    for (const Table& table : content_tables()) {
        if (is_json_table(table)) {
            write_json(database, std::string(table.name), folder);
        } else {
            write_csv(database, sorted_rows_query(table), folder / (std::string(table.name) + ".csv"));
        }
    }
    write_csv(database, behaviour_query() + " ORDER BY pattern_id", folder / "behaviour.csv");
}

}  // namespace fretwork::library::detail

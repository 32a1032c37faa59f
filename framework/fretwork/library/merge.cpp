// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/task.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/library/detail/database.hpp>
#include <fretwork/library/detail/draft.hpp>
#include <fretwork/library/detail/schema.hpp>
#include <fretwork/library/detail/schema3.hpp>
#include <fretwork/library/library.hpp>
#include <fretwork/library/merge.hpp>
#include <fretwork/mechanics/frame/section.hpp>

#include <system_error>

namespace fretwork::library {
namespace {

using detail::Database;
using detail::Statement;
using detail::Table;
using detail::Transaction;

/// "a.x IS b.x AND a.y IS b.y": unlike "=", IS is true for two values that are both NULL, and false for one.
std::string columns_agree(const std::vector<std::string_view>& columns) {
    std::vector<std::string> terms;
    for (const std::string_view column : columns)
        terms.push_back("a." + std::string(column) + " IS b." + std::string(column));
    return base::join(terms, " AND ");
}

/// The rows of a table in the input that is attached as `other`.
std::string other_table(const Database& output, const Table& table) {
    const bool is_lacking =
        table.name == "calibration_parameter" && detail::schema_version(output, "other") == 3;
    return is_lacking ? "(" + detail::schema3_parameters("other") + ")" : "other." + std::string(table.name);
}

/// Refuse rows of `other` that have the same key as a row of the output but differ in a value.
void check_agreement(const Database& output, const Table& table, const std::filesystem::path& input) {
    std::vector<std::string> keys;
    for (const std::string_view key : table.keys) keys.push_back("a." + std::string(key));
    const std::string name(table.name);
    Statement rows(output, "SELECT " + base::join(keys, ", ") + " FROM " + other_table(output, table) +
                               " AS a JOIN main." + name + " AS b ON " + columns_agree(table.keys) +
                               " WHERE NOT (" + columns_agree(table.values) + ") LIMIT 1");
    if (!rows.step()) return;
    std::vector<std::string> place;
    for (int column = 0; column < rows.column_count(); ++column)
        place.push_back(std::string(table.keys[column]) + " " + std::string(rows.text(column)));
    throw base::InputError(
        input.string(), name + " (" + base::join(place, ", ") + ")",
        "differs from the same row of another input (two runs agree to the bit on processors and "
        "C libraries of one kind: see 'arithmetic' in the table provenance)");
}

void copy_rows(Database& output, const Table& table) {
    std::vector<std::string> columns{detail::content_columns(table)};
    columns.insert(columns.end(), table.incidental.begin(), table.incidental.end());
    const std::string list = base::join(columns, ", ");
    const std::string name(table.name);
    output.execute("INSERT OR IGNORE INTO main." + name + " (" + list + ") SELECT " + list + " FROM " +
                   other_table(output, table));
}

void copy_provenance(Database& output) {
    output.execute(
        "INSERT INTO main.provenance SELECT session + (SELECT coalesce(max(session), 0) FROM "
        "main.provenance), "
        "name, value FROM other.provenance");
}

/// Delete recorded failures of computations whose result another input has.
void drop_settled_failures(Database& output) {
    output.execute(
        "DELETE FROM failure WHERE stage = 'responses' AND pattern_id IN (SELECT pattern_id FROM "
        "response_state)");
    output.execute(
        "DELETE FROM failure WHERE EXISTS (SELECT 1 FROM calibration AS c WHERE c.pattern_id = "
        "failure.pattern_id "
        "AND failure.stage = 'calibration ' || c.model || ' ' || c.optimizer || ' seed ' || c.seed || ' "
        "starts ' "
        "|| c.starts || ' budget ' || c.budget)");
}

void attach_and_copy(Database& output, const std::filesystem::path& input) {
    Statement(output, "ATTACH ? AS other").bind_all(std::filesystem::absolute(input).string()).run();
    {
        Transaction transaction(output, Transaction::Kind::Write);
        for (const Table& table : detail::content_tables()) {
            // common_setting() checks settings.
            if (table.name != "setting") check_agreement(output, table, input);
            copy_rows(output, table);
        }
        copy_provenance(output);
        transaction.commit();
    }
    output.execute("DETACH other");
}

/// Add the rows of one input. The output is new and sound, so any error of SQLite is blamed on the input.
void add_input(Database& output, const std::filesystem::path& input) {
    try {
        attach_and_copy(output, input);
    } catch (const base::InputError& error) {
        throw base::renamed(error, output.path().string(), input.string());
    }
}

void merge_into(const std::filesystem::path& path, std::span<const std::filesystem::path> inputs,
                const base::Control& control) {
    const base::Task task(control, "merge", inputs.size());
    Database output(path, Database::Mode::Write);
    const detail::StopGuard stop_guard(output, control);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        control.check();
        add_input(output, inputs[i]);
        task.update(i + 1);
    }
    Transaction transaction(output, Transaction::Kind::Write);
    drop_settled_failures(output);
    transaction.commit();
}

/// Take over another library's strength. Throws InputError if two strengths differ.
void adopt_strength(reduction::Setting& setting, const Library& other) {
    const auto strength = other.setting().strength;
    if (!strength) return;
    const auto text = [](double pascals) { return base::format_number(pascals / 1e6) + " MPa"; };
    if (setting.strength && *setting.strength != *strength)
        throw base::InputError(other.path().string(), "",
                               "has a strength of " + text(*strength) + ", where an earlier input has " +
                                   text(*setting.strength) +
                                   "; calibrate one of them with the other's setting");
    setting.strength = strength;
}

/// Take over another library's shape of the section. Throws InputError if two shapes differ.
void adopt_shape(reduction::Setting& setting, const Library& other) {
    const auto& shape = other.setting().section.shape;
    if (!shape) return;
    auto& known = setting.section.shape;
    if (known && *known != *shape)
        throw base::InputError(other.path().string(), "",
                               std::string("has a section of the shape ") + mechanics::shape_name(*shape) +
                                   ", where an earlier input has another shape (" +
                                   mechanics::shape_name(*known) +
                                   "); calibrate one of them with the other's setting");
    known = shape;
}

/// The setting of all libraries. Layouts and settings must be equal, but some libraries may lack the strength
/// or the shape of the section.
reduction::Setting common_setting(const Library& first, std::span<const std::filesystem::path> others) {
    reduction::Setting setting = first.setting();
    (void)first.patterns();
    for (const auto& input : others) {
        const Library other = Library::open(input);
        (void)other.patterns();  // finds a damaged id, and names its file, before anything is written
        other.check_layout(first.layout());
        other.check_setting(first.setting());
        adopt_strength(setting, other);
        adopt_shape(setting, other);
    }
    return setting;
}

}  // namespace

void merge(const std::filesystem::path& output, std::span<const std::filesystem::path> inputs,
           const base::Control& control) {
    std::error_code ignored;
    if (std::filesystem::exists(output, ignored))
        throw base::InputError(output.string(), "", "exists already");
    if (inputs.empty()) throw base::InputError("nothing to merge: name at least one library");
    const Library first = Library::open(inputs.front());
    const reduction::Setting setting = common_setting(first, inputs.subspan(1));
    const detail::Draft draft(output);
    draft.fill([&] {
        Library::create(draft.path(), first.layout(), setting);
        merge_into(draft.path(), inputs, control);
    });
    if (!draft.move_into_place())
        throw base::IoError(output.string(), "", "another process has made it meanwhile");
}

}  // namespace fretwork::library

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/library/detail/library_impl.hpp>
#include <fretwork/library/detail/schema.hpp>
#include <fretwork/library/library.hpp>

#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace fretwork::library {
namespace {

using detail::Database;
using detail::Statement;
using detail::Transaction;

/// Columns of the search: the id and the mirror image, then the numbers.
std::string searched() {
    return "WITH found AS (SELECT b.pattern_id, b.mirror, p.edges, c.objective, b.mass_per_area, "
           "b.membrane_stiffness, b.membrane_shear, b.membrane_poisson, b.membrane_anisotropy, "
           "b.bending_stiffness, b.bending_shear, b.bending_poisson, b.bending_anisotropy "
           "FROM (" +
           detail::behaviour_query() +
           ") AS b JOIN pattern AS p ON p.id = b.pattern_id "
           "LEFT JOIN (SELECT pattern_id, min(objective) AS objective FROM calibration GROUP BY pattern_id) "
           "AS c ON c.pattern_id = p.id) ";
}

/// Lets what people type read the searched columns, and do nothing else: no other table, no change of the
/// file, no function that reads files.
int allow_search(void*, int action, const char* first, const char* second, const char*, const char*) {
    constexpr std::array<std::string_view, 5> kTables = {"pattern", "property", "calibration", "found", ""};
    if (action == SQLITE_SELECT) return SQLITE_OK;
    if (action == SQLITE_READ)
        return std::ranges::find(kTables, first) != kTables.end() ? SQLITE_OK : SQLITE_DENY;
    if (action == SQLITE_FUNCTION)
        return std::string_view(second) != "load_extension" ? SQLITE_OK : SQLITE_DENY;
    return SQLITE_DENY;
}

/// While it lives, statements are prepared for searches alone.
class SearchOnly {
  public:
    explicit SearchOnly(const Database& database) : handle_(database.handle()) {
        sqlite3_set_authorizer(handle_, allow_search, nullptr);
    }
    SearchOnly(const SearchOnly&) = delete;
    SearchOnly& operator=(const SearchOnly&) = delete;
    ~SearchOnly() { sqlite3_set_authorizer(handle_, nullptr, nullptr); }

  private:
    sqlite3* handle_;
};

/// Throws InputError that names the expression, if it is none, and the place in it.
void check_expression(const Database& database, const char* name, const std::string& expression) {
    for (const std::string_view mark :
         {std::string_view("\0", 1), std::string_view(";"), std::string_view("/*")}) {
        if (expression.find(mark) != std::string::npos)
            throw base::InputError(
                name, "", "'" + base::printable(expression) + "' holds a mark that no expression has");
    }
    const std::string before = searched() + "SELECT ";
    const std::string sql = before + expression + "\nFROM found";
    sqlite3_stmt* statement = nullptr;
    const int code =
        sqlite3_prepare_v2(database.handle(), sql.data(), static_cast<int>(sql.size()), &statement, nullptr);
    const int columns = statement == nullptr ? 0 : sqlite3_column_count(statement);
    const std::string problem = code == SQLITE_OK ? "" : sqlite3_errmsg(database.handle());
    const int offset = code == SQLITE_OK ? -1 : sqlite3_error_offset(database.handle());
    sqlite3_finalize(statement);
    if (code == SQLITE_OK && columns == 1) return;
    const auto place = static_cast<std::size_t>(offset) - before.size();
    const std::string where = offset >= 0 && place < expression.size()
                                  ? " at '" + expression.substr(place, 20) + "'"
                                  : std::string();
    throw base::InputError(name, "",
                           "'" + base::printable(expression) + "' is no expression of the columns" + where +
                               (problem.empty() ? "" : ": " + problem));
}

FoundPattern read_row(const Statement& row) {
    FoundPattern found{std::string(row.text(0)), {}, {}};
    if (row.type(1) != SQLITE_NULL) found.mirror = row.text(1);
    for (int c = 2; c < row.column_count(); ++c) found.values.push_back(row.optional_real(c));
    return found;
}

}  // namespace

FoundPatterns Library::find(const PatternQuery& query) const {
    const SearchOnly search(impl_->database);
    std::string sql = searched() + "SELECT * FROM found";
    if (!query.where.empty()) {
        check_expression(impl_->database, "where", query.where);
        sql += " WHERE (" + query.where + "\n)";
    }
    if (!query.sort.empty()) check_expression(impl_->database, "sort", query.sort);
    const std::string order = query.descending ? " DESC NULLS LAST, " : " ASC NULLS LAST, ";
    sql += " ORDER BY " + (query.sort.empty() ? "" : "(" + query.sort + "\n)" + order) + "pattern_id";
    if (query.limit > 0) sql += " LIMIT " + std::to_string(query.limit);
    Statement rows(impl_->database, sql);
    FoundPatterns found;
    for (int c = 2; c < rows.column_count(); ++c) found.columns.push_back(rows.column_name(c));
    while (rows.step()) found.patterns.push_back(read_row(rows));
    return found;
}

}  // namespace fretwork::library

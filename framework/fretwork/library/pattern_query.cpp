// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/library/detail/library_impl.hpp>
#include <fretwork/library/detail/schema.hpp>
#include <fretwork/library/library.hpp>

#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::library {
namespace {

using detail::Database;
using detail::Statement;
using detail::Transaction;

/// The table that a search reads: the columns are the id, the mirror image and the numbers.
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

/// The authorizer of expressions from users. It permits reading the tables of the search, and all functions
/// but load_extension(). It forbids everything else, such as other tables and changes of the file.
int allow_search(void*, int action, const char* first, const char* second, const char*, const char*) {
    constexpr std::array<std::string_view, 5> kTables = {"pattern", "property", "calibration", "found", ""};
    if (action == SQLITE_SELECT) return SQLITE_OK;
    if (action == SQLITE_READ)
        return std::ranges::find(kTables, first) != kTables.end() ? SQLITE_OK : SQLITE_DENY;
    if (action == SQLITE_FUNCTION)
        return std::string_view(second) != "load_extension" ? SQLITE_OK : SQLITE_DENY;
    return SQLITE_DENY;
}

/// The length of the longest text that an expression may make, bytes.
constexpr int kLongestValue = 1'000'000;

/// Restricts a database to searches as long as this object exists: statements are checked by allow_search(),
/// a word in double quotes is always a column, and no transaction can begin.
class SearchOnly {
  public:
    explicit SearchOnly(const Database& database) : handle_(database.handle()) {
        sqlite3_set_authorizer(handle_, allow_search, nullptr);
        sqlite3_db_config(handle_, SQLITE_DBCONFIG_DQS_DML, -1, &quoted_texts_);
        sqlite3_db_config(handle_, SQLITE_DBCONFIG_DQS_DML, 0, nullptr);
        length_ = sqlite3_limit(handle_, SQLITE_LIMIT_LENGTH, kLongestValue);
    }
    SearchOnly(const SearchOnly&) = delete;
    SearchOnly& operator=(const SearchOnly&) = delete;
    ~SearchOnly() {
        sqlite3_limit(handle_, SQLITE_LIMIT_LENGTH, length_);
        sqlite3_db_config(handle_, SQLITE_DBCONFIG_DQS_DML, quoted_texts_, nullptr);
        sqlite3_set_authorizer(handle_, nullptr, nullptr);
    }

  private:
    sqlite3* handle_;
    int quoted_texts_ = 0;  ///< 1: a word in double quotes that is no column is a text
    int length_ = 0;
};

[[noreturn]] void refuse(const char* name, const std::string& expression, const std::string& problem) {
    throw base::InputError(name, "",
                           "'" + base::printable(expression) + "' is no expression of the columns" + problem);
}

/// The place of the last character of the text or name in quotes that begins at a place: npos if it does not
/// end; the place itself if none begins there. Quotes that are doubled inside a text divide it in two, which
/// changes nothing outside of quotes.
std::size_t end_of_quoted(std::string_view expression, std::size_t place) {
    const char first = expression[place];
    if (first == '\'' || first == '"' || first == '`') return expression.find(first, place + 1);
    if (first == '[') return expression.find(']', place + 1);
    return place;
}

/// What is wrong at a place in an expression.
struct Flaw {
    std::size_t place;
    const char* problem;
};

/// The first thing outside of quotes that would end the brackets that a query puts around the expression, or
/// hide what follows; none if the expression is closed in itself.
std::optional<Flaw> find_flaw(std::string_view expression) {
    std::vector<std::size_t> open;
    std::size_t place = 0;
    while (place < expression.size()) {
        const std::string_view rest = expression.substr(place);
        if (rest.starts_with("--")) return Flaw{place, "-- begins a comment; two signs are - -3 or -(-3)"};
        if (rest.starts_with("/*")) return Flaw{place, "it begins a comment"};
        if (rest.front() == ';') return Flaw{place, "a semicolon ends the expression"};
        if (rest.front() == '(') open.push_back(place);
        if (rest.front() == ')') {
            if (open.empty()) return Flaw{place, "it closes a bracket that is not open"};
            open.pop_back();
        }
        const std::size_t end = end_of_quoted(expression, place);
        if (end == std::string_view::npos) return Flaw{place, "it opens a quote that is not closed"};
        place = end + 1;
    }
    if (!open.empty()) return Flaw{open.back(), "it opens a bracket that is not closed"};
    return std::nullopt;
}

/// Refuse an expression because of what stands at a place in it.
[[noreturn]] void refuse_at(const char* name, const std::string& expression, std::size_t place,
                            const std::string& problem) {
    refuse(name, expression, " at '" + base::printable(expression.substr(place, 20)) + "': " + problem);
}

/// Check an expression. Throws InputError that names the invalid expression and the place of the error in it.
void check_expression(const Database& database, const char* name, const std::string& expression) {
    if (expression.find('\0') != std::string::npos) refuse(name, expression, ": it has the character NUL");
    if (const auto flaw = find_flaw(expression)) refuse_at(name, expression, flaw->place, flaw->problem);
    const std::string before = searched() + "SELECT 1 FROM found WHERE (";
    const std::string sql = before + expression + "\n)";
    sqlite3_stmt* statement = nullptr;
    const int code =
        sqlite3_prepare_v2(database.handle(), sql.data(), static_cast<int>(sql.size()), &statement, nullptr);
    const int parameters = statement == nullptr ? 0 : sqlite3_bind_parameter_count(statement);
    const std::string problem = code == SQLITE_OK ? "" : sqlite3_errmsg(database.handle());
    const int offset = code == SQLITE_OK ? -1 : sqlite3_error_offset(database.handle());
    sqlite3_finalize(statement);
    if (parameters > 0) refuse(name, expression, ": it holds a parameter");
    if (code == SQLITE_OK) return;
    const std::size_t place =
        offset < 0 ? expression.size() : static_cast<std::size_t>(offset) - before.size();
    if (place < expression.size()) refuse_at(name, expression, place, problem);
    // What SQLite names after "near" is the bracket behind the expression.
    refuse(name, expression, ": " + (problem.starts_with("near") ? "it is not complete" : problem));
}

FoundPattern read_row(const Statement& row) {
    FoundPattern found{std::string(row.text(0)), {}, {}};
    if (row.type(1) != SQLITE_NULL) found.mirror = row.text(1);
    for (int c = 2; c < row.column_count(); ++c) found.values.push_back(row.optional_real(c));
    return found;
}

}  // namespace

FoundPatterns Library::find(const PatternQuery& query) const {
    const Transaction snapshot(impl_->database, Transaction::Kind::Read);
    const SearchOnly search(impl_->database);
    std::string sql = searched() + "SELECT * FROM found";
    if (!query.where.empty()) {
        check_expression(impl_->database, "where", query.where);
        sql += " WHERE (" + query.where + "\n)";
    }
    sql += " ORDER BY ";
    if (!query.sort.empty()) {
        check_expression(impl_->database, "sort", query.sort);
        // SQL takes a bare number as the number of a column.
        sql += "CASE WHEN 1 THEN (" + query.sort + "\n) END" + (query.descending ? " DESC" : " ASC") +
               " NULLS LAST, ";
    }
    sql += "pattern_id";
    if (query.limit > 0) sql += " LIMIT " + std::to_string(query.limit);
    Statement rows(impl_->database, sql);
    FoundPatterns found;
    found.known = static_cast<std::size_t>(
        detail::query_integer(impl_->database, searched() + "SELECT count(*) FROM found").value_or(0));
    for (int c = 2; c < rows.column_count(); ++c) found.columns.push_back(rows.column_name(c));
    try {
        while (rows.step()) found.patterns.push_back(read_row(rows));
    } catch (const base::InputError&) {
        const int code = sqlite3_errcode(impl_->database.handle());
        if (code != SQLITE_ERROR && code != SQLITE_TOOBIG) throw;
        const std::string problem = std::string(": ") + sqlite3_errmsg(impl_->database.handle());
        if (query.sort.empty()) refuse("where", query.where, problem);
        if (query.where.empty()) refuse("sort", query.sort, problem);
        refuse("where or sort", query.where + " / " + query.sort, problem);  // SQLite does not say which
    }
    return found;
}

}  // namespace fretwork::library

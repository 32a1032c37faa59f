// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/library/detail/database.hpp>

namespace fretwork::library::detail {
namespace {

constexpr int kBusyTimeoutMilliseconds = 10000;
/// The length of the longest value that is read, bytes. A generated column of a stranger's file could make
/// one of gigabytes.
constexpr int kLongestValue = 1 << 27;

/// Forbid views and triggers in the file's own schema: a view in the place of a table, or a trigger, could
/// run an endless query. The program's own views are temporary and stay allowed.
void distrust_schema(sqlite3* handle) {
    sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, kLongestValue);
}

int open_flags(Database::Mode mode) {
    // A reader also opens the file for writing, if permitted, so that it can roll back the transaction of a
    // killed writer.
    const int create = mode == Database::Mode::CreateOrWrite ? SQLITE_OPEN_CREATE : 0;
    return SQLITE_OPEN_READWRITE | SQLITE_OPEN_EXRESCODE | create;
}

}  // namespace

Database::Database(const std::filesystem::path& path, Mode mode) : path_(path) {
    sqlite3* handle = nullptr;
    // An absolute path, because a name that begins with a colon or "file:" has another meaning in SQLite.
    const std::string name = std::filesystem::absolute(path).string();
    const int code = sqlite3_open_v2(name.c_str(), &handle, open_flags(mode), nullptr);
    handle_.reset(handle);
    if (code != SQLITE_OK) fail(code);
    distrust_schema(handle);
    sqlite3_busy_timeout(handle, kBusyTimeoutMilliseconds);
    execute("PRAGMA foreign_keys = ON");
    if (mode == Mode::Read) execute("PRAGMA query_only = ON");
}

void Database::execute(const std::string& sql) {
    const int code = sqlite3_exec(handle_.get(), sql.c_str(), nullptr, nullptr, nullptr);
    if (code != SQLITE_OK) fail(code);
}

void Database::fail(int code) const {
    const int kind = code & 0xff;
    const std::string what = sqlite3_errstr(code);
    if (kind == SQLITE_INTERRUPT) throw base::Stopped();
    if (kind == SQLITE_NOTADB) throw base::InputError(path_.string(), "", "is not a pattern library");
    if (kind == SQLITE_CORRUPT) throw base::InputError(path_.string(), "", "is damaged (" + what + ")");
    if (kind == SQLITE_TOOBIG)
        throw base::InputError(path_.string(), "",
                               "has a value of more than " + std::to_string(kLongestValue) + " bytes");
    if (kind == SQLITE_BUSY || kind == SQLITE_LOCKED)
        throw base::IoError(path_.string(), "", "is in use by another program");
    if (kind == SQLITE_FULL) throw base::IoError(path_.string(), "", "cannot be written: the disk is full");
    if (kind == SQLITE_IOERR || kind == SQLITE_CANTOPEN || kind == SQLITE_READONLY || kind == SQLITE_PERM)
        throw base::IoError(path_.string(), "", "cannot be read or written: " + what);
    const std::string detail = handle_ ? sqlite3_errmsg(handle_.get()) : what;
    throw base::InputError(path_.string(), "", "does not have the tables of a pattern library: " + detail);
}

Statement::Statement(const Database& database, std::string_view sql) : database_(&database) {
    sqlite3_stmt* handle = nullptr;
    check(sqlite3_prepare_v2(database.handle(), sql.data(), static_cast<int>(sql.size()), &handle, nullptr));
    handle_.reset(handle);
}

void Statement::check(int code) const {
    if (code != SQLITE_OK) database_->fail(code);
}

void Statement::bind(int parameter, std::string_view text) {
    check(sqlite3_bind_text64(handle_.get(), parameter, text.data() == nullptr ? "" : text.data(),
                              text.size(), SQLITE_TRANSIENT, SQLITE_UTF8));
}
void Statement::bind(int parameter, double value) {
    check(sqlite3_bind_double(handle_.get(), parameter, value));
}
void Statement::bind(int parameter, std::int64_t value) {
    check(sqlite3_bind_int64(handle_.get(), parameter, value));
}
void Statement::bind(int parameter, std::optional<double> value) {
    if (value) return bind(parameter, *value);
    check(sqlite3_bind_null(handle_.get(), parameter));
}

bool Statement::step() {
    const int code = sqlite3_step(handle_.get());
    if (code == SQLITE_ROW) return true;
    if (code == SQLITE_DONE) return false;
    database_->fail(code);
}

void Statement::run() {
    while (step()) continue;
    reset();
}

void Statement::reset() {
    sqlite3_reset(handle_.get());  // returns the error of the last step again, which was already thrown
}

void Statement::require_number(int column) const {
    const int kind = type(column);
    if (kind != SQLITE_TEXT && kind != SQLITE_BLOB) return;
    const std::string value = kind == SQLITE_TEXT ? "'" + base::printable(text(column)) + "'" : "a blob";
    throw base::InputError(database_->path().string(), column_name(column),
                           "is damaged: " + value + " is not a number");
}

std::string_view Statement::text(int column) const {
    const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(handle_.get(), column));
    return {bytes == nullptr ? "" : bytes,
            static_cast<std::size_t>(sqlite3_column_bytes(handle_.get(), column))};
}

StopGuard::StopGuard(Database& database, const base::Control& control)
    : database_(database), control_(control.silent()) {
    constexpr int kInstructions = 10'000;  // instructions of SQLite's machine, less than a millisecond
    const auto is_asked_to_stop = [](void* asked) {
        return static_cast<const base::Control*>(asked)->stop_wanted() ? 1 : 0;
    };
    sqlite3_progress_handler(database_.handle(), kInstructions, is_asked_to_stop, &control_);
}

StopGuard::~StopGuard() {
    sqlite3_progress_handler(database_.handle(), 0, nullptr, nullptr);
}

Transaction::Transaction(Database& database, Kind kind) : database_(&database) {
    database.execute(kind == Kind::Write ? "BEGIN IMMEDIATE" : "BEGIN");
}

Transaction::~Transaction() {
    // After some errors, SQLite has already rolled back by itself.
    if (open_ && sqlite3_get_autocommit(database_->handle()) == 0)
        sqlite3_exec(database_->handle(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Transaction::commit() {
    database_->execute("COMMIT");
    open_ = false;
}

std::optional<std::int64_t> query_integer(const Database& database, std::string_view sql) {
    Statement statement(database, sql);
    if (!statement.step()) return std::nullopt;
    return statement.integer(0);
}

}  // namespace fretwork::library::detail

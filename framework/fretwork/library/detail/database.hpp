// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>

#include <sqlite3.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace fretwork::library::detail {

/// An open SQLite file. Each error is an InputError (no database, damaged), or an IoError (disk full, no
/// permission, locked), and names the file.
class Database {
  public:
    enum class Mode { Read, Write, CreateOrWrite };
    Database(const std::filesystem::path& path, Mode mode);

    /// Run SQL that gives no rows.
    void execute(const std::string& sql);
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] sqlite3* handle() const { return handle_.get(); }
    /// The number of rows that the last statement inserted, changed or deleted.
    [[nodiscard]] std::int64_t changed_rows() const { return sqlite3_changes(handle_.get()); }
    [[nodiscard]] bool is_read_only() const { return sqlite3_db_readonly(handle_.get(), "main") == 1; }
    /// Throw the error that an SQLite code other than success stands for.
    [[noreturn]] void fail(int code) const;

  private:
    struct Close {
        void operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }
    };
    std::filesystem::path path_;
    std::unique_ptr<sqlite3, Close> handle_;
};

/// A prepared statement. Parameters are numbered from 1, columns from 0.
class Statement {
  public:
    Statement(const Database& database, std::string_view sql);

    void bind(int parameter, std::string_view text);
    void bind(int parameter, double value);
    void bind(int parameter, std::int64_t value);
    void bind(int parameter, int value) { bind(parameter, static_cast<std::int64_t>(value)); }
    void bind(int parameter, std::optional<double> value);  ///< NULL if empty
    /// Bind all parameters in turn.
    template <class... Values>
    Statement& bind_all(const Values&... values) {
        reset();
        int parameter = 0;
        (bind(++parameter, values), ...);
        return *this;
    }

    /// Go to the next row. False if there is no further row.
    bool step();
    /// Run the statement to its end, and reset it for the next run.
    void run();
    void reset();

    [[nodiscard]] std::string column_name(int column) const {
        return sqlite3_column_name(handle_.get(), column);
    }
    [[nodiscard]] int column_count() const { return sqlite3_column_count(handle_.get()); }
    [[nodiscard]] int type(int column) const { return sqlite3_column_type(handle_.get(), column); }
    /// The text in a column; valid until the next step().
    [[nodiscard]] std::string_view text(int column) const;
    /// The number in a column. Throws InputError that names the column if its value is a text or a blob,
    /// which SQLite itself would convert, for example to 0.
    [[nodiscard]] double real(int column) const {
        require_number(column);
        return sqlite3_column_double(handle_.get(), column);
    }
    [[nodiscard]] std::optional<double> optional_real(int column) const {
        return type(column) == SQLITE_NULL ? std::nullopt : std::optional(real(column));
    }
    [[nodiscard]] std::int64_t integer(int column) const {
        require_number(column);
        return sqlite3_column_int64(handle_.get(), column);
    }
    /// An integer that is known to be small.
    [[nodiscard]] int count(int column) const { return static_cast<int>(integer(column)); }

  private:
    void check(int code) const;
    void require_number(int column) const;
    struct Finalize {
        void operator()(sqlite3_stmt* handle) const { sqlite3_finalize(handle); }
    };
    const Database* database_;
    std::unique_ptr<sqlite3_stmt, Finalize> handle_;
};

/// Ends long statements of a database when a stop is requested. As long as this object exists, a statement
/// throws base::Stopped once the control asks to stop, and the statement's transaction is rolled back.
class StopGuard {
  public:
    StopGuard(Database& database, const base::Control& control);
    StopGuard(const StopGuard&) = delete;
    StopGuard& operator=(const StopGuard&) = delete;
    ~StopGuard();

  private:
    Database& database_;
    base::Control control_;
};

/// A transaction that is rolled back unless it is committed. All its reads see the same state of the file. A
/// write transaction locks the file from its start, so its reads stay valid until the commit.
class Transaction {
  public:
    enum class Kind { Read, Write };
    Transaction(Database& database, Kind kind);
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    ~Transaction();
    void commit();

  private:
    Database* database_;
    bool open_ = true;
};

/// The first column of the first row, if there is a row.
std::optional<std::int64_t> query_integer(const Database& database, std::string_view sql);

}  // namespace fretwork::library::detail

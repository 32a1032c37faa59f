// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <sqlite3.h>

#include <functional>

namespace fretwork::library {
namespace THIS_TEST {

using namespace test;
using testing::AllOf;
using testing::HasSubstr;

class BadLibrary : public testing::Test {
  protected:
    [[nodiscard]] std::filesystem::path path() const { return folder_.path() / "lib.db"; }
    [[nodiscard]] std::string complaint() const {
        return complaint_of([&] { (void)Library::open(path()); });
    }
    /// Change the file by SQL, without the library.
    void sql(const std::string& text) const {
        sqlite3* handle = nullptr;
        ASSERT_EQ(sqlite3_open(path().c_str(), &handle), SQLITE_OK);
        EXPECT_EQ(sqlite3_exec(handle, text.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
            << sqlite3_errmsg(handle);
        sqlite3_close(handle);
    }
    TemporaryFolder folder_;
};

TEST_F(BadLibrary, AMissingFileIsNamedAndNotCreated) {
    EXPECT_THAT(complaint(), AllOf(HasSubstr("lib.db"), HasSubstr("no such file")));
    EXPECT_FALSE(std::filesystem::exists(path()));
}

TEST_F(BadLibrary, FoldersTextFilesAndEmptyFilesAreRefused) {
    EXPECT_THAT(complaint_of([&] { (void)Library::open(folder_.path()); }), HasSubstr("is a folder"));
    base::write_file_atomically(path(), std::string(5000, 'x'));
    EXPECT_THAT(complaint(), HasSubstr("is not a pattern library"));
    base::write_file_atomically(path(), "");
    EXPECT_THAT(complaint(), HasSubstr("is not a pattern library"));
}

TEST_F(BadLibrary, OtherSqliteFilesAreRefusedAndNotOverwritten) {
    sql("CREATE TABLE recipe(name TEXT)");
    EXPECT_THAT(complaint(), HasSubstr("is not a pattern library"));
    EXPECT_THAT(complaint_of([&] { make_library(path()); }), HasSubstr("exists already"));
}

TEST_F(BadLibrary, ANewerVersionIsRefusedWithBothNumbers) {
    make_library(path());
    sql("PRAGMA user_version = 7");
    EXPECT_THAT(complaint(), AllOf(HasSubstr("version 7"), HasSubstr("up to 4"), HasSubstr("newer program")));
}

TEST_F(BadLibrary, VersionsBefore3AreRefusedWithAdvice) {
    make_library(path());
    sql("PRAGMA user_version = 2");
    EXPECT_THAT(complaint(), AllOf(HasSubstr("version 2"), HasSubstr("from 3 on"),
                                   HasSubstr("enumerate its patterns into a new library")));
}

TEST_F(BadLibrary, CreateRefusesAnExistingLibrary) {
    make_library(path());
    EXPECT_THAT(complaint_of([&] { make_library(path()); }), HasSubstr("exists already"));
    EXPECT_EQ(Library::open(path()).pattern_count(), sample_ids().size());
}

TEST_F(BadLibrary, ATruncatedFileIsRefused) {
    make_library(path()).store(std::vector{sample_data("0-1+1-6", 1.0)});
    std::filesystem::resize_file(path(), std::filesystem::file_size(path()) / 2);
    EXPECT_THAT(complaint_of([&] { (void)Library::open(path()).content_hash(); }), HasSubstr("is damaged"));
}

TEST_F(BadLibrary, MissingTablesAndRowsAreNamed) {
    make_library(path());
    sql("DELETE FROM setting");
    EXPECT_THAT(complaint(), HasSubstr("setting: is missing"));
    sql("PRAGMA foreign_keys = OFF; DROP TABLE layout");
    EXPECT_THAT(complaint(), HasSubstr("no such table: layout"));
}

TEST_F(BadLibrary, RowsThatTheSettingDoesNotHaveAreRefused) {
    make_library(path()).store(std::vector{sample_data("0-1+1-6", 1.0)});
    sql("UPDATE response SET node = 17 WHERE node = 5");
    EXPECT_THAT(complaint_of([&] { (void)Library::open(path()).responses("0-1+1-6"); }),
                HasSubstr("node 17"));
}

TEST_F(BadLibrary, APatternThatTheLayoutDoesNotHaveIsRefused) {
    make_library(path());
    sql("INSERT INTO pattern VALUES ('0-99', 'paper7', 1, NULL)");
    EXPECT_THAT(complaint_of([&] { (void)Library::open(path()).patterns(); }), HasSubstr("0-99"));
}

TEST_F(BadLibrary, AnIdThatIsNoPatternIsToldWithItsFile) {
    make_library(path());
    sql("PRAGMA foreign_keys = OFF; UPDATE pattern SET id = '-1.0e' WHERE id = '0-1+1-6'");
    for (const auto& read : std::vector<std::function<void(const Library&)>>{
             [](const Library& library) { (void)library.patterns(); },
             [](const Library& library) { (void)library.summaries(); },
             [](const Library& library) { (void)library.sample(4); }}) {
        EXPECT_THAT(complaint_of([&] { read(Library::open(path())); }),
                    AllOf(HasSubstr("lib.db: pattern: "), HasSubstr("'-1.0e' is not an edge")));
    }
}

/// SQLite keeps any text in a column of numbers, and reads it as 0.
TEST_F(BadLibrary, ATextInThePlaceOfANumberIsNotReadAsZero) {
    make_library(path()).store(std::vector{sample_data("0-1+1-6", 1.0)});
    sql("UPDATE calibration SET objective = 'abc'");
    for (const auto& read : std::vector<std::function<void(const Library&)>>{
             [](const Library& library) { (void)library.summaries(); },
             [](const Library& library) { (void)library.calibrations("0-1+1-6"); }}) {
        EXPECT_THAT(complaint_of([&] { read(Library::open(path())); }),
                    AllOf(HasSubstr("lib.db: "), HasSubstr("objective"), HasSubstr("'abc' is not a number")));
    }
    sql("UPDATE calibration SET objective = 1.0; UPDATE calibration_parameter SET value = x'00ff'");
    EXPECT_THAT(complaint_of([&] { (void)Library::open(path()).calibrations("0-1+1-6"); }),
                HasSubstr("value: is damaged: a blob is not a number"));
}

/// A computed column could make gigabytes of a file of a few kilobytes.
TEST_F(BadLibrary, AComputedColumnIsRefused) {
    make_library(path());
    sql("PRAGMA foreign_keys = OFF; DROP VIEW behaviour; DROP TABLE layout; CREATE TABLE layout "
        "(name TEXT PRIMARY KEY, json TEXT GENERATED ALWAYS AS (hex(zeroblob(400000000))))");
    EXPECT_THAT(complaint(), AllOf(HasSubstr("lib.db"), HasSubstr("layout: has a computed column, 'json'")));
}

/// A view that never ends, where a table is expected.
TEST_F(BadLibrary, AViewInThePlaceOfATableIsRefused) {
    for (const char* table : {"layout", "setting", "pattern", "calibration", "failure", "provenance"}) {
        std::filesystem::remove(path());
        make_library(path());
        sql("PRAGMA foreign_keys = OFF; DROP VIEW behaviour; DROP TABLE " + std::string(table) +
            "; CREATE VIEW " + table +
            " AS WITH RECURSIVE n(id) AS (SELECT 1 UNION ALL SELECT id + 1 FROM n) SELECT id, id AS json "
            "FROM n");
        EXPECT_THAT(complaint(), AllOf(HasSubstr("lib.db"), HasSubstr(std::string(table) + ": is a view")))
            << table;
    }
}

TEST_F(BadLibrary, TriggersOfAFileDoNotRun) {
    make_library(path());
    sql("CREATE TRIGGER t AFTER INSERT ON pattern BEGIN DELETE FROM pattern; END");
    Library library = Library::open(path(), Access::ReadWrite);
    library.add_patterns(parse({"0-1+1-5+5-6"}));
    EXPECT_EQ(library.pattern_count(), sample_ids().size() + 1);
}

TEST_F(BadLibrary, WritingThroughAReadOnlyLibraryIsRefused) {
    make_library(path());
    Library library = Library::open(path());
    EXPECT_THROW(library.store(std::vector{sample_data("0-1+1-6", 1.0)}), base::IoError);
}

TEST_F(BadLibrary, AMissingFolderIsNotCreated) {
    EXPECT_THROW(make_library(folder_.path() / "none" / "lib.db"), base::IoError);
}

}  // namespace THIS_TEST
}  // namespace fretwork::library

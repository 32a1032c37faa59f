// SPDX-License-Identifier: GPL-3.0-or-later
// A library that a program of schema 3 made: 11 patterns of the layout spider4, two of them calibrated with
// both models of that time, with the setting {"magnitudes": 1, "divisions": 1, "scenarios": ["axial",
// "bending"]}.
#include "sample.hpp"
#include "support.hpp"

#include <fretwork/library/library.hpp>
#include <fretwork/library/merge.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace fretwork::library {
namespace THIS_TEST {

using fretwork::test::TemporaryFolder;
using reduction::NamedValue;
using test::sample_calibration;
using testing::IsEmpty;

const std::filesystem::path kOld =
    std::filesystem::path(FRETWORK_SOURCE_DIR) / "tests/library/data/schema3.db";

/// The content hash that the program of that time gave, as a project of that time names it.
constexpr const char* kOldHash = "3ababd91c9610e7589c21b27fbeaa9476c5e1d3447703e3e034bc40edff825a0";

class Schema3 : public testing::Test {
  protected:
    Schema3() { std::filesystem::copy_file(kOld, path()); }
    [[nodiscard]] std::filesystem::path path() const { return folder_.path() / "old.db"; }
    TemporaryFolder folder_;
};

void expect_content(const Library& library) {
    EXPECT_EQ(library.pattern_count(), 11U);
    const auto records = library.calibrations("1-2+1-3");
    ASSERT_EQ(records.size(), 2U);
    EXPECT_EQ(records[0].calibration.model, "condensed");
    EXPECT_THAT(records[0].calibration.parameters, IsEmpty()) << "nothing is fitted, so nothing is stored";
    EXPECT_EQ(records[1].calibration.model, "paper6");
    EXPECT_EQ(records[1].calibration.parameters.size(), 6U);
    EXPECT_EQ(records[1].calibration.parameters[0], (NamedValue{"A", 1.1103277648671545e-06}));
    EXPECT_EQ(records[1].calibration.parameters[4], (NamedValue{"R", 0.01327964041919419}));
    EXPECT_EQ(records[1].calibration.objective, 0.03346785366355094);
    EXPECT_TRUE(library.has_content(kOldHash));
    EXPECT_FALSE(library.has_content(std::string(64, '0')));
}

TEST_F(Schema3, IsReadAsItIs) {
    const std::string before = base::read_text_file(path());
    expect_content(Library::open(path()));
    EXPECT_EQ(base::read_text_file(path()), before) << "reading writes nothing";
}

TEST_F(Schema3, IsChangedToThisSchemaWhenItIsOpenedForWriting) {
    const std::string hash = Library::open(path()).content_hash();
    expect_content(Library::open(path(), Access::ReadWrite));
    expect_content(Library::open(path()));
    EXPECT_EQ(Library::open(path()).content_hash(), hash);
    Library library = Library::open(path(), Access::ReadWrite);
    PatternData data{"0-1+1-3", {}, {sample_calibration(2.0)}, {}};
    data.calibrations[0].calibration.scenario_errors = {1.0, 1.0};
    library.store(std::vector{data});
    EXPECT_EQ(library.calibrations("0-1+1-3").size(), 1U);
}

TEST_F(Schema3, MergesToTheSameContentAsAfterTheChange) {
    const std::filesystem::path changed = folder_.path() / "changed.db";
    std::filesystem::copy_file(path(), changed);
    (void)Library::open(changed, Access::ReadWrite);
    merge(folder_.path() / "a.db", std::vector{path()});
    merge(folder_.path() / "b.db", std::vector{changed, path()});
    for (const char* name : {"a.db", "b.db"}) {
        const Library merged = Library::open(folder_.path() / name);
        expect_content(merged);
        EXPECT_EQ(merged.content_hash(), Library::open(changed).content_hash());
    }
}

TEST_F(Schema3, ExportsTheTablesOfThisSchema) {
    Library::open(path()).export_csv(folder_.path() / "csv");
    const std::string text = base::read_text_file(folder_.path() / "csv" / "calibration_parameter.csv");
    EXPECT_THAT(text, testing::StartsWith("pattern_id,model,optimizer,seed,starts,budget,name,value\n"));
    EXPECT_EQ(std::ranges::count(text, '\n'), 13) << "a header, and two calibrations of six parameters";
}

}  // namespace THIS_TEST
}  // namespace fretwork::library

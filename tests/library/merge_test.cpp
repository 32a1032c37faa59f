// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/library/detail/draft.hpp>
#include <fretwork/library/merge.hpp>
#include <fretwork/mechanics/frame/section.hpp>
#include <fretwork/reduction/scenarios/setting_file.hpp>

#include <sqlite3.h>

namespace fretwork::library {
namespace THIS_TEST {

using namespace test;
using testing::HasSubstr;
using Paths = std::vector<std::filesystem::path>;

class Merge : public testing::Test {
  protected:
    [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }
    /// A library of all sample patterns with data of some.
    std::filesystem::path shard(const std::string& name, const std::vector<PatternData>& data,
                                const std::vector<Failure>& failures = {}) {
        make_library(path(name)).store(data, failures);
        return path(name);
    }
    [[nodiscard]] std::string hash(const std::string& name) const {
        return Library::open(path(name)).content_hash();
    }
    TemporaryFolder folder_;
};

TEST_F(Merge, ShardsGiveWhatOneRunGivesInAnyOrder) {
    const auto first = sample_data("0-1+1-6", 1.0);
    const auto second = sample_data("1-6+3-6", 2.0);
    const auto a = shard("a.db", {first});
    const auto b = shard("b.db", {second}, {{"0-6+1-6+3-6", "responses", "too soft"}});
    shard("one.db", {second, first}, {{"0-6+1-6+3-6", "responses", "too soft"}});
    merge(path("ab.db"), Paths{a, b});
    merge(path("ba.db"), Paths{b, a});
    EXPECT_EQ(hash("ab.db"), hash("one.db"));
    EXPECT_EQ(hash("ba.db"), hash("one.db"));
    Library::open(path("ab.db")).export_csv(path("ab"));
    Library::open(path("ba.db")).export_csv(path("ba"));
    EXPECT_EQ(folder_content(path("ab")), folder_content(path("ba")));
    EXPECT_EQ(ids_of(Library::open(path("ab.db")).patterns()),
              ids_of(Library::open(path("ba.db")).patterns()));
}

TEST_F(Merge, ADamagedInputIsNamedAndNothingIsLeft) {
    const auto a = shard("a.db", {sample_data("0-1+1-6", 1.0)});
    const auto b = shard("b.db", {});
    sqlite3* handle = nullptr;
    ASSERT_EQ(sqlite3_open(b.c_str(), &handle), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(handle, "UPDATE pattern SET id = '-1.0e' WHERE id = '1-6+3-6'", nullptr, nullptr,
                           nullptr),
              SQLITE_OK);
    sqlite3_close(handle);
    for (const Paths& inputs : {Paths{a, b}, Paths{b, a}}) {
        EXPECT_THAT(complaint_of([&] { merge(path("m.db"), inputs); }),
                    AllOf(HasSubstr("b.db"), HasSubstr("'-1.0e' is not an edge")));
        EXPECT_FALSE(std::filesystem::exists(path("m.db")));
    }
}

TEST_F(Merge, IsAssociativeAndAcceptsEqualRows) {
    const auto first = sample_data("0-1+1-6", 1.0);
    const auto second = sample_data("1-6+3-6", 2.0);
    const auto a = shard("a.db", {first});
    const auto b = shard("b.db", {first, second});
    merge(path("ab.db"), Paths{a, b});
    merge(path("abab.db"), Paths{path("ab.db"), a, b, path("ab.db")});
    EXPECT_EQ(hash("abab.db"), hash("ab.db"));
    EXPECT_EQ(hash("ab.db"), hash("b.db"));
}

TEST_F(Merge, AFailureIsDroppedIfAnotherInputHasTheResult) {
    const CalibrationKey key = sample_calibration(1.0).key();
    const auto a = shard("a.db", {sample_data("0-1+1-6", 1.0)});
    const auto b = shard("b.db", {},
                         {{"0-1+1-6", responses_computation(), "killed"},
                          {"0-1+1-6", calibration_computation(key), "killed"},
                          {"1-6+3-6", calibration_computation(key), "killed"}});
    merge(path("ab.db"), Paths{a, b});
    const auto failures = Library::open(path("ab.db")).failures();
    ASSERT_EQ(failures.size(), 1U);
    EXPECT_EQ(failures[0].pattern, "1-6+3-6");
}

TEST_F(Merge, LeavesNoOutputWhenItIsStopped) {
    std::stop_source source;
    source.request_stop();
    const auto input = shard("a.db", {sample_data("0-1+1-6", 1.0)});
    EXPECT_THROW(merge(path("ab.db"), Paths{input}, {.stop = source.get_token()}), base::Stopped);
    EXPECT_FALSE(std::filesystem::exists(path("ab.db")));
}

TEST_F(Merge, RowsThatDifferAreRefusedByName) {
    const auto a = shard("a.db", {sample_data("0-1+1-6", 1.0)});
    const auto b = shard("b.db", {sample_data("0-1+1-6", 1.5)});
    const std::string complaint = complaint_of([&] { merge(path("ab.db"), Paths{a, b}); });
    EXPECT_THAT(complaint, HasSubstr("b.db"));
    EXPECT_THAT(complaint, HasSubstr("pattern_id 0-1+1-6"));
    EXPECT_THAT(complaint, HasSubstr("'arithmetic' in the table provenance"));
    EXPECT_FALSE(std::filesystem::exists(path("ab.db")));
    EXPECT_EQ(folder_content(folder_.path()).size(), 2U) << "nothing is left beside the inputs";
}

TEST_F(Merge, AnEstimateThatOnlyOneInputHasIsADifference) {
    auto with = sample_data("0-1+1-6", 1.0);
    with.responses.front().samples.front().discretization_error = 1e-3;
    auto without = sample_data("0-1+1-6", 1.0);
    without.responses.front().samples.front().discretization_error.reset();
    const auto a = shard("a.db", {with});
    const auto b = shard("b.db", {without});
    for (const Paths& inputs : {Paths{a, b}, Paths{b, a}})
        EXPECT_THAT(complaint_of([&] { merge(path("ab.db"), inputs); }), HasSubstr("response_state"));
}

TEST_F(Merge, SettingsThatDifferAreRefused) {
    reduction::Setting setting = reduction::paper_setting();
    setting.tile_side = 0.05;
    Library::create(path("b.db"), paper_layout(), setting);
    const auto a = shard("a.db", {});
    EXPECT_THAT(complaint_of([&] { merge(path("ab.db"), Paths{a, path("b.db")}); }), HasSubstr("tile_side"));
}

TEST_F(Merge, AStrengthThatOneInputTellsIsTakenAndTwoMustAgree) {
    reduction::Setting strong = reduction::paper_setting();
    strong.strength = 4e7;
    const auto a = shard("a.db", {sample_data("0-1+1-6", 1.0)});
    const auto b = shard("b.db", {sample_data("1-6+3-6", 2.0)});
    const auto c = shard("c.db", {sample_data("1-6+3-6", 2.0)});
    Library::open(b, Access::ReadWrite).adopt_setting(strong);
    merge(path("ab.db"), Paths{a, b});
    EXPECT_EQ(Library::open(path("ab.db")).setting().strength, 4e7);
    merge(path("ba.db"), Paths{b, a});
    EXPECT_EQ(Library::open(path("ba.db")).setting().strength, 4e7);
    strong.strength = 6e7;
    Library::open(c, Access::ReadWrite).adopt_setting(strong);
    EXPECT_THAT(complaint_of([&] {
                    merge(path("abc.db"), Paths{a, b, c});
                }),
                HasSubstr("has a strength of 60 MPa, where an earlier input has 40 MPa"));
}

TEST_F(Merge, AShapeThatOneInputTellsIsTaken) {
    reduction::Setting circle = reduction::paper_setting();
    circle.section = mechanics::circle_section(2e-3);
    const reduction::Setting numbers = reduction::without_stresses(circle);
    Library::create(path("a.db"), paper_layout(), numbers).add_patterns(parse({"0-1+1-6"}));
    Library::create(path("b.db"), paper_layout(), circle).add_patterns(parse({"1-6+3-6"}));
    merge(path("ab.db"), Paths{path("a.db"), path("b.db")});
    merge(path("ba.db"), Paths{path("b.db"), path("a.db")});
    EXPECT_EQ(Library::open(path("ab.db")).setting(), circle);
    EXPECT_EQ(Library::open(path("ba.db")).setting(), circle);
}

TEST_F(Merge, AnOutputCreatedMeanwhileIsNotOverwritten) {
    const detail::Draft draft(path("out.db"));
    base::write_file_atomically(draft.path(), "draft");
    base::write_file_atomically(path("out.db"), "of another process");
    EXPECT_FALSE(draft.move_into_place());
    EXPECT_EQ(base::read_text_file(path("out.db")), "of another process");
}

TEST_F(Merge, AnExistingOutputIsNotOverwritten) {
    const auto a = shard("a.db", {});
    const std::string before = base::read_text_file(a);
    EXPECT_THAT(complaint_of([&] { merge(a, Paths{a}); }), HasSubstr("exists already"));
    EXPECT_EQ(base::read_text_file(a), before);
    EXPECT_THAT(complaint_of([&] { merge(path("new.db"), Paths{}); }), HasSubstr("nothing to merge"));
    EXPECT_THAT(complaint_of([&] { merge(path("no/new.db"), Paths{a}); }), HasSubstr("new.db"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::library

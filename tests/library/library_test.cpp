// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <fretwork/base/text.hpp>
#include <fretwork/library/detail/pattern_order.hpp>
#include <fretwork/library/statistics.hpp>
#include <fretwork/reduction/scenarios/setting_file.hpp>
#include <fretwork/reduction/stratified_sample.hpp>

#include <algorithm>
#include <limits>

namespace fretwork::library {
namespace THIS_TEST {

using namespace test;
using testing::HasSubstr;
using testing::SizeIs;

class LibraryTest : public testing::Test {
  protected:
    [[nodiscard]] std::filesystem::path path(const std::string& name = "lib.db") const {
        return folder_.path() / name;
    }
    TemporaryFolder folder_;
};

void expect_equal(const std::vector<reduction::Response>& left,
                  const std::vector<reduction::Response>& right) {
    ASSERT_EQ(left.size(), right.size());
    for (std::size_t r = 0; r < left.size(); ++r) {
        EXPECT_EQ(left[r].scenario, right[r].scenario);
        ASSERT_EQ(left[r].samples.size(), right[r].samples.size());
        for (std::size_t k = 0; k < left[r].samples.size(); ++k) {
            const auto& a = left[r].samples[k];
            const auto& b = right[r].samples[k];
            EXPECT_EQ(a.step, b.step);
            EXPECT_EQ(a.magnitude, b.magnitude);
            EXPECT_EQ(a.converged, b.converged);
            EXPECT_EQ(a.stable, b.stable);
            EXPECT_EQ(a.limit_load, b.limit_load);
            EXPECT_EQ(a.discretization_error, b.discretization_error);
            EXPECT_EQ(a.displacements, b.displacements);
        }
    }
}

TEST_F(LibraryTest, GivesBackWhatWasStoredToTheLastBit) {
    const PatternData data = sample_data("0-1+1-6", 0.7);
    make_library(path()).store(std::vector{data});
    const Library library = Library::open(path());
    expect_equal(library.responses("0-1+1-6"), data.responses);
    const auto calibrations = library.calibrations("0-1+1-6");
    ASSERT_THAT(calibrations, SizeIs(1));
    const CalibrationRecord& wanted = data.calibrations[0];
    const CalibrationRecord& got = calibrations[0];
    EXPECT_EQ(got.key(), wanted.key());
    EXPECT_EQ(got.seconds, wanted.seconds);
    EXPECT_EQ(got.calibration.objective, wanted.calibration.objective);
    EXPECT_EQ(got.calibration.scenario_errors, wanted.calibration.scenario_errors);
    EXPECT_EQ(got.calibration.cost, wanted.calibration.cost);
    EXPECT_EQ(got.calibration.at_bound, wanted.calibration.at_bound);
    EXPECT_EQ(got.calibration.parameters, wanted.calibration.parameters);
    EXPECT_EQ(library.properties("0-1+1-6"), data.properties);
}

TEST_F(LibraryTest, KeepsItsLayoutAndSetting) {
    make_library(path());
    const Library library = Library::open(path());
    EXPECT_EQ(library.setting(), reduction::paper_setting());
    EXPECT_EQ(pattern::node_layout_text(library.layout()), pattern::node_layout_text(paper_layout()));
    EXPECT_NO_THROW(library.check_setting(reduction::paper_setting()));
    EXPECT_NO_THROW(library.check_layout(paper_layout()));
}

TEST_F(LibraryTest, AnotherSettingIsRefusedWithTheDifference) {
    const Library library = make_library(path());
    reduction::Setting other = reduction::paper_setting();
    other.tile_side = 0.05;
    EXPECT_THAT(complaint_of([&] { library.check_setting(other); }), HasSubstr("tile_side"));
    EXPECT_THAT(complaint_of([&] { Library::open_or_create(path(), paper_layout(), other); }),
                HasSubstr("tile_side"));
}

TEST_F(LibraryTest, AdoptsAnotherSettingOnlyBeforeAnythingIsComputed) {
    reduction::Setting other = reduction::paper_setting();
    other.tile_side = 0.05;
    other.scenarios.pop_back();
    Library library = make_library(path());
    library.adopt_setting(other);
    EXPECT_EQ(library.setting(), other);
    EXPECT_EQ(Library::open(path()).setting(), other);
    PatternData data{"0-1+1-6", sample_responses(other, 1.0), {}, {}};
    library.store(std::vector{data});
    EXPECT_NO_THROW(library.adopt_setting(other));
    EXPECT_THAT(complaint_of([&] { library.adopt_setting(reduction::paper_setting()); }),
                HasSubstr("setting"));
    EXPECT_EQ(library.setting(), other);
}

TEST_F(LibraryTest, NothingIsStoredWithASettingThatAnotherProcessHasReplaced) {
    reduction::Setting other = reduction::paper_setting();
    other.tile_side = 0.05;
    Library first = make_library(path());
    Library second = Library::open(path(), Access::ReadWrite);
    first.adopt_setting(other);
    EXPECT_THAT(complaint_of([&] { second.store(std::vector{sample_data("0-1+1-6", 2.0)}); }),
                HasSubstr("another setting meanwhile: /tile_side"));
    EXPECT_TRUE(Library::open(path()).responses("0-1+1-6").empty());
    second.adopt_setting(other);
    EXPECT_EQ(second.setting(), other);
}

TEST_F(LibraryTest, OfTwoProcessesThatChooseASettingTheFirstToStoreDecides) {
    reduction::Setting other = reduction::paper_setting();
    other.tile_side = 0.05;
    Library first = make_library(path());
    Library second = Library::open(path(), Access::ReadWrite);
    first.adopt_setting(other);
    PatternData data{"0-1+1-6", sample_responses(other, 1.0), {}, {}};
    first.store(std::vector{data});
    EXPECT_THAT(complaint_of([&] { second.adopt_setting(reduction::paper_setting()); }),
                HasSubstr("is of another setting: /tile_side"));
}

TEST_F(LibraryTest, AdoptsAStrengthAlsoAfterSomethingIsComputed) {
    Library library = make_library(path());
    library.store(std::vector{sample_data("0-1+1-6", 2.0)});
    reduction::Setting other = library.setting();
    other.strength = 4e7;
    const std::string hash = library.content_hash();
    library.adopt_setting(other);
    EXPECT_EQ(library.setting(), other);
    EXPECT_EQ(library.content_hash(), hash) << "projects that name it still find it";
    EXPECT_EQ(Library::open(path()).setting(), other);
    library.adopt_setting(reduction::without_stresses(other));
    EXPECT_EQ(library.setting(), other) << "a setting without a strength says nothing of it";
}

TEST_F(LibraryTest, AdoptsAShapeAlsoAfterSomethingIsComputed) {
    reduction::Setting circle = reduction::paper_setting();
    circle.section = mechanics::circle_section(2e-3);
    const reduction::Setting numbers = reduction::without_stresses(circle);
    Library library = Library::create(path(), paper_layout(), numbers);
    library.add_patterns(parse({"0-1+1-6"}));
    library.store(std::vector{sample_data("0-1+1-6", 2.0)});
    const std::string hash = library.content_hash();
    library.adopt_setting(circle);
    EXPECT_EQ(Library::open(path()).setting(), circle);
    EXPECT_EQ(library.content_hash(), hash) << "projects that name it still find it";
    library.adopt_setting(numbers);
    EXPECT_EQ(library.setting(), circle) << "numbers say nothing of the shape";
}

TEST_F(LibraryTest, AnInvalidSettingIsRefusedBeforeAnythingIsWritten) {
    reduction::Setting other = reduction::paper_setting();
    other.divisions = 101;
    EXPECT_THAT(complaint_of([&] { Library::create(path(), paper_layout(), other); }),
                HasSubstr("/divisions"));
    EXPECT_THAT(complaint_of([&] { Library::open_or_create(path(), paper_layout(), other); }),
                HasSubstr("/divisions"));
    EXPECT_FALSE(std::filesystem::exists(path()));
    Library library = make_library(path());
    library.store(std::vector{sample_data("0-1+1-6", 2.0)});
    other = library.setting();
    other.strength = -1.0;
    EXPECT_THAT(complaint_of([&] { library.adopt_setting(other); }), HasSubstr("/material/strength"));
    EXPECT_EQ(Library::open(path()).setting(), reduction::paper_setting());
}

TEST_F(LibraryTest, SummariesCountWhatThereIsOfEachPattern) {
    Library library = make_library(path());
    library.store(std::vector{sample_data("0-1+1-6", 2.0)},
                  std::vector<Failure>{{"1-6+3-6", "responses", "soft"}});
    const auto summaries = library.summaries();
    ASSERT_THAT(summaries, SizeIs(4));
    EXPECT_EQ(summaries[0].pattern, "0-1+1-6");
    EXPECT_EQ(summaries[0].edges, 2);
    EXPECT_EQ(summaries[0].samples, 50);
    EXPECT_EQ(summaries[0].converged_samples, 45);
    EXPECT_EQ(summaries[0].stable_samples, 40);
    EXPECT_EQ(summaries[0].limit_load_samples, 5);
    EXPECT_EQ(summaries[0].calibrations, 1);
    EXPECT_EQ(summaries[0].best_objective, 0.5);
    EXPECT_EQ(summaries[1].pattern, "1-6+3-6");
    EXPECT_EQ(summaries[1].samples, 0);
    EXPECT_EQ(summaries[1].failures, 1);
    EXPECT_FALSE(summaries[1].best_objective.has_value());
}

TEST_F(LibraryTest, AnotherLayoutIsRefused) {
    const Library library = make_library(path());
    pattern::NodeLayoutDescription description = paper_layout().description();
    description.radial = {pattern::Rational(1, 2)};
    EXPECT_THAT(complaint_of([&] { library.check_layout(pattern::NodeLayout(description)); }),
                HasSubstr("other nodes"));
    description.name = "mine";
    EXPECT_THAT(complaint_of([&] { library.check_layout(pattern::NodeLayout(description)); }),
                HasSubstr("paper7, not mine"));
}

TEST_F(LibraryTest, ListsPatternsInTheOrderOfTheEnumeration) {
    std::vector<std::string> ids = sample_ids();
    const auto forward = ids_of(make_library(path("a.db"), ids).patterns());
    std::reverse(ids.begin(), ids.end());
    EXPECT_EQ(ids_of(make_library(path("b.db"), ids).patterns()), forward);
    EXPECT_EQ(forward.front(), "0-1+1-6");
    EXPECT_EQ(forward.back(), "0-1+1-5+3-6+5-6");
}

TEST_F(LibraryTest, AddingPatternsTwiceAddsThemOnce) {
    Library library = make_library(path());
    const std::string hash = library.content_hash();
    EXPECT_EQ(library.add_patterns(parse(sample_ids())), 0U);
    EXPECT_EQ(library.add_patterns(parse({"1-6+3-6", "0-1+0-6+1-6"})), 1U);
    EXPECT_EQ(library.pattern_count(), sample_ids().size() + 1);
    EXPECT_NE(library.content_hash(), hash);
}

TEST_F(LibraryTest, AddsNoPatternAndExportsNoTableWhenItIsStopped) {
    std::stop_source source;
    source.request_stop();
    const base::Control stopped{.stop = source.get_token()};
    Library library = make_library(path());
    const std::size_t before = library.pattern_count();
    EXPECT_THROW(library.add_patterns(parse({"1-6+3-6"}), stopped), base::Stopped);
    EXPECT_EQ(Library::open(library.path()).pattern_count(), before);
    const auto missing = path("none.db");
    EXPECT_THROW(Library::open_or_create(missing, paper_layout(), reduction::paper_setting(),
                                         parse({"1-6+3-6"}), stopped),
                 base::Stopped);
    EXPECT_FALSE(std::filesystem::exists(missing));
    EXPECT_THROW(library.export_csv(path("csv"), stopped), base::Stopped);
}

TEST_F(LibraryTest, FindsPatternsByAnyFormOfTheirIdAndSuggestsTheNearest) {
    const Library library = make_library(path());
    EXPECT_EQ(library.find_pattern("paper7:1-6+0-1").id, "0-1+1-6");
    EXPECT_THAT(complaint_of([&] { (void)library.find_pattern("0-1+2-6"); }), HasSubstr("did you mean"));
}

TEST_F(LibraryTest, ASampleIsThatOfAllPatternsInOrder) {
    // Nodes of more than one digit: the order of ids as texts is another one.
    const pattern::NodeLayout layout = pattern::find_node_layout("quarters10");
    const auto edges = layout.candidate_edges().size();
    std::vector<pattern::Pattern> patterns;
    for (std::size_t i = 0; i < 300; ++i) {
        pattern::Pattern::Bits bits;
        for (std::size_t k = 0; k < 3 + i % 4; ++k) bits.set((i * 7 + k * (5 + i % 3)) % edges);
        patterns.emplace_back(bits);
    }
    Library library = Library::create(path(), layout, reduction::paper_setting());
    library.add_patterns(patterns);
    const std::vector<pattern::NamedPattern> all = library.patterns();
    EXPECT_TRUE(std::ranges::is_sorted(all, comes_before));
    std::vector<int> strata;
    for (const pattern::NamedPattern& entry : all) strata.push_back(entry.pattern.edge_count());
    for (const std::size_t size : {1U, 7U, 40U, 1000U}) {
        std::vector<std::string> expected;
        for (const std::size_t i : reduction::stratified_sample(strata, size)) expected.push_back(all[i].id);
        EXPECT_EQ(ids_of(library.sample(size)), expected);
    }
}

TEST_F(LibraryTest, TheOrderOfIdsIsThatOfTheirEdges) {
    const pattern::NodeLayout layout = pattern::find_node_layout("quarters10");
    const auto edges = layout.candidate_edges();
    std::vector<pattern::NamedPattern> entries;
    for (std::size_t a = 0; a < edges.size(); ++a) {
        for (std::size_t b = a + 1; b < edges.size(); ++b) {
            const pattern::Pattern pattern(pattern::Pattern::Bits().set(a).set(b));
            entries.push_back({pattern_id(layout, pattern), pattern});
        }
    }
    for (const pattern::NamedPattern& left : entries) {
        for (const pattern::NamedPattern& right : entries) {
            EXPECT_EQ(detail::id_comes_before(left.id, right.id),
                      left.pattern.edges() < right.pattern.edges());
            EXPECT_EQ(comes_before(left, right), left.pattern.edges() < right.pattern.edges());
        }
    }
}

TEST_F(LibraryTest, ObjectivesFarAboveTheirLikeAreTold) {
    std::vector<double> objectives(19, 4.0);
    EXPECT_TRUE(std::isinf(far_above_limit(objectives))) << "nineteen tell too little";
    objectives.push_back(4.0);
    EXPECT_EQ(far_above_limit(objectives), 40.0) << "ten times, where all are alike";
    objectives.back() = 4170.0;
    EXPECT_EQ(far_above_limit(objectives), 40.0) << "a failed search does not move it";
    for (std::size_t i = 0; i < objectives.size(); ++i) objectives[i] = i < 10 ? 1.0 : 9.0;
    EXPECT_TRUE(std::isinf(far_above_limit(std::vector<double>(20, 0.0)))) << "no ratio to zero exists";
    // The median is 5; of |log(E / 5)| it is (log 5 + log 1.8) / 2 = log 3.
    EXPECT_NEAR(far_above_limit(objectives), 5.0 * std::exp(4.0 * 1.4826 * std::log(3.0)), 1e-9);
}

TEST_F(LibraryTest, PatternsLeftToComputeShrinkAsResultsAndFailuresAreStored) {
    Library library = make_library(path());
    const CalibrationKey key = sample_calibration(1).key();
    EXPECT_THAT(library.patterns_without_responses(), SizeIs(4));
    EXPECT_THAT(library.patterns_without_calibration(key), SizeIs(4));
    library.store(std::vector{sample_data("0-1+1-6", 1.0)},
                  std::vector<Failure>{{"1-6+3-6", responses_computation(), "too soft"},
                                       {"0-6+1-6+3-6", calibration_computation(key), "no start converged"}});
    EXPECT_EQ(ids_of(library.patterns_without_responses()),
              (std::vector<std::string>{"0-6+1-6+3-6", "0-1+1-5+3-6+5-6"}));
    EXPECT_EQ(ids_of(library.patterns_with_responses()), std::vector<std::string>{"0-1+1-6"});
    EXPECT_EQ(ids_of(library.patterns_without_calibration(key)),
              (std::vector<std::string>{"0-1+1-5+3-6+5-6"}));
    CalibrationKey other = key;
    other.seed = 2;
    EXPECT_THAT(library.patterns_without_calibration(other), SizeIs(3));
    library.forget_failures();
    EXPECT_THAT(library.patterns_without_responses(), SizeIs(3));
}

TEST_F(LibraryTest, StoringAResultForgetsTheFailureRecordedForIt) {
    Library library = make_library(path());
    const CalibrationKey key = sample_calibration(1).key();
    library.store({}, std::vector<Failure>{{"0-1+1-6", responses_computation(), "once"},
                                           {"0-1+1-6", calibration_computation(key), "once"},
                                           {"1-6+3-6", responses_computation(), "for good"}});
    library.store(std::vector{sample_data("0-1+1-6", 1.0)});
    EXPECT_EQ(library.failures(), (std::vector<Failure>{{"1-6+3-6", "responses", "for good"}}));
}

TEST_F(LibraryTest, StoringTheSameAgainChangesNothing) {
    Library library = make_library(path());
    library.store(std::vector{sample_data("0-1+1-6", 1.0)});
    const std::string hash = library.content_hash();
    PatternData again = sample_data("0-1+1-6", 1.0);
    again.calibrations[0].seconds = 99.0;
    library.store(std::vector{again});
    EXPECT_EQ(library.content_hash(), hash);
}

TEST_F(LibraryTest, StoringADifferentValueIsRefusedWithItsWholeBatch) {
    Library library = make_library(path());
    library.store(std::vector{sample_data("0-1+1-6", 1.0)});
    const std::string hash = library.content_hash();
    const std::vector batch{sample_data("1-6+3-6", 2.0), sample_data("0-1+1-6", 3.0)};
    EXPECT_THAT(complaint_of([&] { library.store(batch); }), HasSubstr("0-1+1-6"));
    EXPECT_EQ(library.content_hash(), hash);
    PatternData other = sample_data("0-1+1-6", 1.0);
    other.calibrations[0].calibration.cost += 1;
    EXPECT_THAT(complaint_of([&] { library.store(std::vector{other}); }), HasSubstr("calibration"));
}

TEST_F(LibraryTest, ResponsesThatDoNotFitTheSettingAreRefused) {
    Library library = make_library(path());
    const auto complaint = [&](auto&& spoil) {
        PatternData data = sample_data("0-1+1-6", 1.0);
        spoil(data);
        return complaint_of([&] { library.store(std::vector{data}); });
    };
    EXPECT_THAT(complaint([](PatternData& d) { d.pattern = "0-1+2-6"; }), HasSubstr("no pattern 0-1+2-6"));
    EXPECT_THAT(complaint([](PatternData& d) { d.responses.pop_back(); }), HasSubstr("5 are needed"));
    EXPECT_THAT(complaint([](PatternData& d) { d.responses[1].scenario = "twist"; }), HasSubstr("twist"));
    EXPECT_THAT(complaint([](PatternData& d) { d.responses[1].samples.pop_back(); }), HasSubstr("shear"));
    EXPECT_THAT(complaint([](PatternData& d) { d.responses[2].samples[3].step = 7; }), HasSubstr("step 7"));
    EXPECT_THAT(complaint([](PatternData& d) { d.responses[0].samples[0].displacements.resize(5, 6); }),
                HasSubstr("5 rows"));
    EXPECT_THAT(complaint([](PatternData& d) {
                    d.responses[0].samples[0].displacements(2, 2) = std::numeric_limits<double>::quiet_NaN();
                }),
                HasSubstr("not finite"));
    EXPECT_THAT(library.patterns_without_responses(), SizeIs(4));
}

TEST_F(LibraryTest, CalibrationsThatCannotBeStoredAreRefused) {
    Library library = make_library(path());
    const auto complaint = [&](auto&& spoil) {
        PatternData data{"0-1+1-6", {}, {sample_calibration(1.0)}, {}};
        spoil(data.calibrations[0].calibration);
        return complaint_of([&] { library.store(std::vector{data}); });
    };
    EXPECT_THAT(complaint([](auto& c) { c.seed = 1ULL << 63U; }), HasSubstr("below 2^63"));
    EXPECT_THAT(complaint([](auto& c) { c.scenario_errors.pop_back(); }), HasSubstr("4 errors"));
    EXPECT_THAT(complaint([](auto& c) { c.objective = std::numeric_limits<double>::infinity(); }),
                HasSubstr("not finite"));
}

TEST_F(LibraryTest, TheBestCalibrationHasTheSmallestObjectiveOfItsModel) {
    Library library = make_library(path());
    PatternData data{"0-1+1-6", {}, {sample_calibration(3.0, 1), sample_calibration(2.0, 2)}, {}};
    data.calibrations.push_back(sample_calibration(1.0, 3));
    data.calibrations.back().calibration.model = "ring10";
    library.store(std::vector{data});
    const auto best = library.best_calibrations("0-1+1-6");
    ASSERT_EQ(best.size(), 2U);
    EXPECT_EQ(best[0].model, "paper6");
    EXPECT_EQ(best[0].seed, 2U);
    EXPECT_EQ(best[1].model, "ring10");
    EXPECT_EQ(best[1].seed, 3U);
    EXPECT_TRUE(library.best_calibrations("1-6+3-6").empty());
}

TEST_F(LibraryTest, TheContentHashDoesNotDependOnTheOrderOfStoring) {
    Library forward = make_library(path("a.db"));
    Library backward = make_library(path("b.db"), {"0-1+1-5+5-6+3-6", "0-6+1-6+3-6"});
    forward.store(std::vector{sample_data("0-1+1-6", 1.0), sample_data("1-6+3-6", 2.0)});
    backward.add_patterns(parse(sample_ids()));
    backward.store(std::vector{sample_data("1-6+3-6", 2.0)});
    EXPECT_NE(forward.content_hash(), backward.content_hash());
    backward.store(std::vector{sample_data("0-1+1-6", 1.0)});
    EXPECT_EQ(forward.content_hash(), backward.content_hash());
    EXPECT_THAT(forward.content_hash(), SizeIs(64));
}

TEST_F(LibraryTest, ExportedTablesAreEqualForEqualContentAndReadBackExactly) {
    Library forward = make_library(path("a.db"));
    Library backward = make_library(path("b.db"), {"0-1+1-5+5-6+3-6", "1-6+3-6", "0-6+1-6+3-6", "0-1+1-6"});
    forward.store(std::vector{sample_data("0-1+1-6", 1.0), sample_data("1-6+3-6", 2.0)});
    PatternData late = sample_data("0-1+1-6", 1.0);
    late.calibrations[0].seconds = 77.0;
    backward.store(std::vector{sample_data("1-6+3-6", 2.0)});
    backward.store(std::vector{late});
    forward.export_csv(path("a"));
    backward.export_csv(path("b") / "nested");
    EXPECT_EQ(folder_content(path("a")), folder_content(path("b") / "nested"));

    EXPECT_TRUE(base::read_text_file(path("a") / "behaviour.csv").starts_with("pattern_id,mirror,"));
    const auto lines = base::split(base::read_text_file(path("a") / "response.csv"), '\n');
    EXPECT_EQ(lines.front(), "pattern_id,scenario,step,node,ux,uy,uz,rx,ry,rz");
    EXPECT_THAT(lines, SizeIs(1 + 2 * 5 * 9 * 6 + 1));  // header, converged samples, end of the last line
    const auto fields = base::split(lines[1], ',');
    EXPECT_EQ(fields[0], "0-1+1-6");
    EXPECT_EQ(std::stod(fields[5]),
              sample_responses(reduction::paper_setting(), 1.0)[0].samples[0].displacements(0, 1));
}

TEST_F(LibraryTest, TextWithCommasAndQuotesIsQuotedInTables) {
    Library library = make_library(path());
    library.store({}, std::vector<Failure>{{"0-1+1-6", "responses", "a \"quoted\", long reason"}});
    library.export_csv(path("csv"));
    EXPECT_EQ(base::read_text_file(path("csv") / "failure.csv"),
              "pattern_id,stage,reason\n0-1+1-6,responses,\"a \"\"quoted\"\", long reason\"\n");
}

}  // namespace THIS_TEST
}  // namespace fretwork::library

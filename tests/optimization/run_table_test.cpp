// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimization/analytic_problems.hpp"
#include "optimization/evolution_strategy.hpp"
#include "support.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/studies/known_value.hpp>
#include <fretwork/optimization/studies/run_table.hpp>
#include <fretwork/optimization/studies/study_problem.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <regex>
#include <set>

namespace fretwork::optimization::study {
namespace THIS_TEST {

using optimization::find_optimizer;
using optimization::optimizer_catalogue;
using optimization::sphere;

RunRecord sphere_run(const std::string& optimizer, int repetition, const RunConditions& conditions) {
    const auto problem = sphere(2);
    return record_run({problem, Eigen::Vector2d(0.1, 0.2)}, {&find_optimizer(optimizer), 2},
                      {"sphere", optimizer, repetition}, conditions);
}

std::vector<std::string> cells_of(const RunRecord& record) {
    return base::split(run_table_row(record), ',');
}

TEST(Contenders, AreAllMethodsOfTheCatalogue) {
    const auto contenders = default_contenders();
    ASSERT_EQ(contenders.size(), optimizer_catalogue().size());
    for (std::size_t i = 0; i < contenders.size(); ++i) {
        EXPECT_EQ(contenders[i].method, &optimizer_catalogue()[i]);
        EXPECT_GE(contenders[i].starts, 1);
    }
}

TEST(RunSeed, DiffersByProblemMethodRepetitionAndStudy) {
    std::set<std::uint64_t> seeds;
    for (const char* problem : {"a", "b"}) {
        for (const char* optimizer : {"x", "y"}) {
            for (const int repetition : {1, 2}) {
                for (const std::uint64_t base : {1U, 2U}) {
                    seeds.insert(run_seed({problem, optimizer, repetition}, base));
                }
            }
        }
    }
    EXPECT_EQ(seeds.size(), 16U);
    // The first 16 digits of `printf '1|a|x|1' | sha256sum`.
    EXPECT_EQ(run_seed({"a", "x", 1}, 1), 0xa78559729a100107U);
}

TEST(Contenders, AreRepeatedUnlessTheyAreDeterministic) {
    EXPECT_EQ(repetitions_of({&find_optimizer("direct-l"), 1}, 15), 1);
    EXPECT_EQ(repetitions_of({&find_optimizer("bobyqa"), 1}, 15), 15);
    EXPECT_EQ(repetitions_of({&find_optimizer("cma-es"), 1}, 15), 15);
}

TEST(RecordRun, TellsWhereTheMethodStoppedAndHowFarTheOptimumIs) {
    const RunConditions conditions{.budget = {.cost = 700}};
    const auto record = sphere_run("simulated-annealing", 1, conditions);
    const auto problem = sphere(2);
    EXPECT_EQ(record.last_value, problem.value(record.report.final_point));
    EXPECT_GT(record.last_value, record.report.value);
    const Eigen::VectorXd miss = record.report.point - Eigen::Vector2d(0.1, 0.2);
    EXPECT_DOUBLE_EQ(record.distance, miss.lpNorm<Eigen::Infinity>() / 5.0);
    EXPECT_GT(record.cpu_seconds, 0.0);
}

TEST(RunTable, HasOneCellForEachColumn) {
    const auto record = sphere_run("bobyqa", 3, {});
    const auto names = base::split(run_table_header(), ',');
    const auto cells = cells_of(record);
    ASSERT_EQ(cells.size(), names.size());
    EXPECT_EQ(cells[0], "sphere");
    EXPECT_EQ(cells[2], "3");
    EXPECT_EQ(cells[9], base::format_number(record.report.value));
    EXPECT_EQ(cells[12], std::to_string(record.report.cost));
}

TEST(RunTable, KeepsPointsOfATraceThatLeaveAFifthLessToGain) {
    RunRecord record = sphere_run("bobyqa", 1, {});
    // 4 is the end: 6, 5.9, 1, 0.9, 1e-4 and 0.9e-4 are left to gain.
    record.report.trace = {{1, 10.0}, {2, 9.9}, {3, 5.0}, {5, 4.9}, {6, 4.0001}, {7, 4.00009}, {9, 4.0}};
    EXPECT_EQ(cells_of(record)[17], "1:10 3:5 6:4.0001 9:4");
}

TEST(RunTable, ReadsBackItsOwnCsv) {
    const RunConditions conditions{.budget = {.cost = 100}};
    const std::vector<Contender> contenders{{&find_optimizer("bobyqa"), 2}, {&find_optimizer("crs2"), 2}};
    RunTable table;
    for (const char* optimizer : {"crs2", "bobyqa"}) table.add(sphere_run(optimizer, 1, conditions));
    const RunTable again(table.csv(), "results.csv", conditions, contenders);
    EXPECT_EQ(again.csv(), table.csv());
    EXPECT_TRUE(again.contains({"sphere", "crs2", 1}));
    EXPECT_FALSE(again.contains({"sphere", "crs2", 2}));
    EXPECT_LT(table.csv().find("bobyqa"), table.csv().find("crs2")) << "rows are sorted";
}

TEST(RunTable, ReadsLinesThatEndInCrLf) {
    const RunConditions conditions{.budget = {.cost = 100}};
    const std::vector<Contender> contenders{{&find_optimizer("bobyqa"), 2}};
    RunTable table;
    table.add(sphere_run("bobyqa", 1, conditions));
    const std::string crlf = std::regex_replace(table.csv(), std::regex("\n"), "\r\n");
    EXPECT_EQ(RunTable(crlf, "results.csv", conditions, contenders).csv(), table.csv());
}

TEST(RunTable, TakesAMethodThatIsInNoCatalogue) {
    const auto problem = sphere(2);
    const Contender contender{&own::kEvolutionStrategy, 2};
    const RunKey key{"sphere", std::string(contender.method->name), 1};
    RunTable table;
    table.add(record_run({problem, Eigen::Vector2d(0.1, 0.2)}, contender, key, {.budget = {.cost = 500}}));
    EXPECT_TRUE(table.contains(key));
    EXPECT_THAT(table.csv(), testing::HasSubstr("sphere,evolution-strategy,1,random,2,2,"));
}

TEST(RunTable, MergesTheRunsThatItLacks) {
    RunTable table;
    RunTable other;
    table.add(sphere_run("bobyqa", 1, {}));
    other.add(sphere_run("bobyqa", 1, {}));
    other.add(sphere_run("bobyqa", 2, {}));
    table.merge(other);
    EXPECT_EQ(table.size(), 2U);
    EXPECT_TRUE(table.contains({"sphere", "bobyqa", 2}));
}

/// A row of a method that is a program of its own; only its name and command matter here.
OptimizerRow outside(const std::string& command) {
    OptimizerRow row = find_optimizer("bobyqa");
    row.name = "mine";
    row.command = command;
    return row;
}

TEST(RunTable, KeepsTheCommandOfAProgram) {
    const OptimizerRow row = outside("sed 's/,/\"/'\n");
    const RunConditions conditions{.budget = {.cost = 100}};
    const auto problem = sphere(2);
    RunTable table;
    table.add(record_run({problem, {}}, {&row, 2}, {"sphere", "mine", 1}, conditions));
    const std::vector<Contender> contenders{{&row, 2}};
    EXPECT_EQ(RunTable(table.csv(), "results.csv", conditions, contenders).csv(), table.csv());
    EXPECT_THAT(table.csv(), testing::HasSubstr(",\"sed 's/,/\"\"/'\\x0a\"\n"));
}

TEST(RunTable, RefusesTheRowsOfAnotherCommandUnderTheSameName) {
    const OptimizerRow earlier = outside("./old, fast");
    const OptimizerRow later = outside("./new");
    const RunConditions conditions{.budget = {.cost = 100}};
    const auto problem = sphere(2);
    RunTable table;
    table.add(record_run({problem, {}}, {&earlier, 2}, {"sphere", "mine", 1}, conditions));
    const std::vector<Contender> contenders{{&later, 2}};
    try {
        const RunTable again(table.csv(), "results.csv", conditions, contenders);
        ADD_FAILURE() << "rows of another command are taken";
    } catch (const base::InputError& error) {
        EXPECT_STREQ(
            error.what(),
            "results.csv: line 2: rows of 'mine' were made by another command: \"./old, fast\"; choose "
            "another name or another output folder");
    }
    EXPECT_EQ(RunTable(table.csv(), "results.csv", conditions, {}).size(), 1U) << "it does not take part";
}

TEST(RunTable, ReadsTablesWithoutCommands) {
    const RunConditions conditions{.budget = {.cost = 100}};
    RunTable table;
    table.add(sphere_run("bobyqa", 1, conditions));
    std::string earlier = table.csv();  // as versions wrote it that had no such column
    earlier.erase(earlier.find(",command"), std::string_view(",command").size());
    earlier.erase(earlier.rfind(','), 1);
    const std::vector<Contender> contenders{{&find_optimizer("bobyqa"), 2}};
    EXPECT_EQ(RunTable(earlier, "results.csv", conditions, contenders).csv(), table.csv());
    const OptimizerRow now = outside("./new");
    RunTable of_unknown;
    auto record = sphere_run("bobyqa", 1, conditions);
    record.key.optimizer = "mine";
    record.seed = run_seed(record.key, conditions.seed);
    of_unknown.add(record);
    const std::vector<Contender> outsiders{{&now, 2}};
    EXPECT_THROW(RunTable(of_unknown.csv(), "results.csv", conditions, outsiders), base::InputError);
}

/// A problem whose minimum is not known, but whose scale is.
ProblemFamilies own_families() {
    const auto make = [](const std::string& id, const std::string&) {
        return StudyProblem{id, std::make_shared<LeastSquaresProblem>(sphere(2)), std::nullopt, {}, 2.5};
    };
    return {ProblemFamily{"own", make}};
}

TEST(KnownValues, KeepTheScaleThatAProblemStates) {
    const auto found = find_known_values({"own/x"}, {.families = own_families(), .starts = 2, .threads = 1});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().scale, 2.5);
    EXPECT_LT(found.front().best_value, 1e-6);
}

TEST(KnownValues, TakeABetterValueAsScaleOnlyWhereTheOldOneWasIt) {
    const test::TemporaryFolder folder;
    RunTable table;
    table.add(sphere_run("bobyqa", 1, {}));
    const auto results = folder.file("results.csv", table.csv());
    std::vector<KnownValue> stated = {{"sphere", 9.0, 2.5, "before"}};
    std::vector<KnownValue> lowest = {{"sphere", 9.0, 9.0, "before"}};
    improve_known_values(stated, results);
    improve_known_values(lowest, results);
    EXPECT_LT(stated.front().best_value, 9.0);
    EXPECT_EQ(stated.front().scale, 2.5);
    EXPECT_EQ(lowest.front().scale, lowest.front().best_value);
}

void expect_refused(const std::string& text, const RunConditions& conditions, const std::string& complaint) {
    const std::vector<Contender> contenders{{&find_optimizer("bobyqa"), 2}};
    try {
        const RunTable table(text, "results.csv", conditions, contenders);
        ADD_FAILURE() << complaint;
    } catch (const base::InputError& error) {
        EXPECT_THAT(error.what(),
                    testing::AllOf(testing::HasSubstr("results.csv"), testing::HasSubstr(complaint)));
    }
}

TEST(RunTable, RefusesRowsOfOtherConditionsAndBrokenOnes) {
    const RunConditions conditions{.budget = {.cost = 100}};
    RunTable table;
    table.add(sphere_run("bobyqa", 1, conditions));
    expect_refused(table.csv(), {.budget = {.cost = 101}},
                   "line 2: this run was made with another budget, 100");
    expect_refused(table.csv(), {.budget = {.cost = 100}, .seed = 2}, "another seed");
    expect_refused("a,b\n", conditions, "line 1");
    expect_refused("", conditions, "line 1");
    expect_refused(run_table_header() + "\nsphere,bobyqa,1\n", conditions, "has 3 columns");
    const auto with = [&](const std::string& piece, const std::string& by) {
        std::string text = table.csv();
        const auto place = text.rfind(piece);
        return text.replace(place, piece.size(), by);
    };
    const std::string row = table.csv().substr(run_table_header().size() + 1);
    expect_refused(table.csv() + row, conditions, "line 3: this run stands in the table already");
    const auto cells = base::split(row, ',');
    expect_refused(with("," + cells[8] + ",", ",bugdet,"), conditions, "'bugdet'");
    expect_refused(with("," + cells[8] + "," + cells[9], "," + cells[8] + ",abc"), conditions, "value 'abc'");
    expect_refused(with(cells[17], "x:y"), conditions, "trace");
    expect_refused(with("," + cells[16] + ",", ",-1,"), conditions, "CPU time '-1'");
}

}  // namespace THIS_TEST
}  // namespace fretwork::optimization::study

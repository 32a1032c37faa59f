// SPDX-License-Identifier: GPL-3.0-or-later
// Methods that are programs of their own. Those here are lines of Python or of the shell.
#include "analytic_problems.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/optimization/methods/outside_command.hpp>
#include <fretwork/optimization/minimize.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <limits>

namespace fretwork::optimization {
namespace THIS_TEST {

/// A program that asks for one point over and over, whatever it is told.
const std::string kDeaf =
    "python3 -c '\nfor _ in range(5): input()\nwhile True:\n    print(\"value 0 0 0\", flush=True)\n    "
    "input()\n'";

/// A program of Python that has read the first five lines: `lower`, `upper`, `seed`, and `ask(word, point)`.
std::string python(const std::string& body) {
    return "python3 -c '\n"
           "import random\n"
           "def ask(word, point):\n"
           "    print(word, *map(repr, point), flush=True)\n"
           "    return input()\n"
           "_, lower, upper, seed, _ = [input().split()[1:] for _ in range(5)]\n"
           "lower, upper = list(map(float, lower)), list(map(float, upper))\n" +
           body + "'";
}

/// A search that draws its first point, and then goes along the axes by ever smaller steps.
const std::string kCompass = python(
    "random.seed(int(seed[0]))\n"
    "point = [random.uniform(a, b) for a, b in zip(lower, upper)]\n"
    "best = float(ask(\"value\", point))\n"
    "step = 0.25\n"
    "while step > 1e-6:\n"
    "    found = False\n"
    "    for i in range(len(point)):\n"
    "        for sign in (-1, 1):\n"
    "            trial = list(point)\n"
    "            trial[i] = min(max(trial[i] + sign * step * (upper[i] - lower[i]), lower[i]), upper[i])\n"
    "            value = float(ask(\"value\", trial))\n"
    "            if value < best: point, best, found = trial, value, True\n"
    "    if not found: step /= 2\n"
    "print(\"done\")\n");

OptimizationReport run(const std::string& command, const Budget& budget = {.cost = 5000},
                       std::uint64_t seed = 3) {
    const auto row = outside_command_row({"outside", command});
    return minimize(sphere(3), row, {.starts = 1, .seed = seed}, budget);
}

std::string complaint(const std::string& command) {
    try {
        (void)run(command);
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(OutsideCommand, MinimizesAsAMethodOfTheCatalogueDoes) {
    const auto report = run(kCompass);
    EXPECT_LT(report.value, 1e-9);
    EXPECT_EQ(report.ending, Ending::Converged);
    EXPECT_EQ(report.optimizer, "outside");
    EXPECT_EQ(report.cost, report.evaluations);
    EXPECT_EQ(report.derivative_evaluations, 0);
    EXPECT_EQ(report.final_point, report.point);
}

TEST(OutsideCommand, GivesTheSameTraceForTheSameSeed) {
    EXPECT_EQ(run(kCompass).trace, run(kCompass).trace);
    EXPECT_NE(run(kCompass).trace, run(kCompass, {.cost = 5000}, 4).trace);
}

TEST(OutsideCommand, GetsTheProblemsOwnGradient) {
    // The command itself checks the slope by central differences.
    const auto report =
        run(python("point = [0.5, -0.4, 1.0]\n"
                   "value, *slope = map(float, ask(\"gradient\", point).split())\n"
                   "assert float(ask(\"value\", point)) == value\n"
                   "h = 1e-5\n"
                   "for i in range(3):\n"
                   "    ends = [[p + s * h * (i == k) for k, p in enumerate(point)] for s in (-1, 1)]\n"
                   "    low, high = (float(ask(\"value\", end)) for end in ends)\n"
                   "    assert abs((high - low) / (2 * h) - slope[i]) < 1e-6, (slope, low, high)\n"
                   "print(\"done stalled\")\n"));
    EXPECT_EQ(report.derivative_evaluations, 1);
    EXPECT_EQ(report.evaluations, 8);
    EXPECT_EQ(report.ending, Ending::Stalled);
}

TEST(OutsideCommand, IsRefusedWhatIsSpentAndWhatLiesOutside) {
    const auto report = run(python("beyond = [upper[0] + 1.0, 0.0, 0.0]\n"
                                   "assert ask(\"value\", beyond) == \"outside\"\n"
                                   "for _ in range(2): assert ask(\"value\", [0.5, 0.5, 0.5]) != \"spent\"\n"
                                   "assert ask(\"value\", [0.0, 0.0, 0.0]) == \"spent\"\n"),
                            {.cost = 2});
    EXPECT_EQ(report.cost, 2);
    EXPECT_EQ(report.points_outside, 1);
    EXPECT_EQ(report.ending, Ending::BudgetSpent);
    EXPECT_GT(report.value, 0.0);
}

TEST(OutsideCommand, ThatGoesOnAfterItsBudgetIsSpentIsStoppedAndItsRunKept) {
    const auto report = run(kDeaf, {.cost = 7});
    EXPECT_EQ(report.ending, Ending::Stopped);
    EXPECT_EQ(report.cost, 7);
    EXPECT_EQ(report.value, sphere(3).value(Eigen::Vector3d::Zero()));
}

TEST(OutsideCommand, ThatIsSilentAfterItsTimeIsStoppedAndItsRunKept) {
    const auto report =
        run("head -n 5 >/dev/null; echo value 0 0 0; read answer; sleep 30", {.seconds = 2.0});
    EXPECT_EQ(report.ending, Ending::Stopped);
    EXPECT_EQ(report.cost, 1);
    EXPECT_EQ(report.value, sphere(3).value(Eigen::Vector3d::Zero()));
}

/// Asks to stop after some seconds, so that a run which would wait without end fails.
std::function<bool()> after(std::chrono::seconds limit) {
    return
        [end = std::chrono::steady_clock::now() + limit] { return std::chrono::steady_clock::now() > end; };
}

TEST(OutsideCommand, ThatNeverReadsIsStoppedAfterItsTimeAndItsRunKept) {
    const std::function<bool()> question = after(std::chrono::seconds(20));
    base::Control control;
    control.question = &question;
    const auto report = run("yes \"value 0 0 0\"", {.cost = 1'000'000, .seconds = 1.0, .control = control});
    EXPECT_EQ(report.ending, Ending::Stopped);
    EXPECT_EQ(report.value, sphere(3).value(Eigen::Vector3d::Zero()));
}

// Neither has a limit of time: the first fills all that lies between the two programs, the second costs
// nothing.
TEST(OutsideCommand, ThatNeverReadsOrAsksOnlyOutsideIsStoppedAndItsRunKept) {
    const std::function<bool()> question = after(std::chrono::seconds(60));
    base::Control control;
    control.question = &question;
    const auto deaf = run("yes \"value 0 0 0\"", {.cost = 1'000'000, .control = control});
    EXPECT_EQ(deaf.ending, Ending::Stopped);
    EXPECT_EQ(deaf.value, sphere(3).value(Eigen::Vector3d::Zero()));
    const auto astray =
        run("echo value 0 0 0; while read line; do echo value nan nan nan; done", {.control = control});
    EXPECT_EQ(astray.ending, Ending::Stopped);
    EXPECT_EQ(astray.cost, 1);
    EXPECT_GT(astray.points_outside, 100'000);
}

TEST(OutsideCommand, MayAskManyTimesBeforeItReadsTheAnswers) {
    const std::function<bool()> question = after(std::chrono::seconds(60));
    base::Control control;
    control.question = &question;
    const auto report = run(python("for _ in range(40000): print(\"value 0 0 0\")\n"
                                   "for _ in range(40000): assert float(input()) > 0.0\n"
                                   "print(\"done\")\n"),
                            {.cost = 40000, .control = control});
    EXPECT_EQ(report.evaluations, 40000);
    EXPECT_EQ(report.ending, Ending::Converged);
}

TEST(OutsideCommand, HearsThatItsBudgetIsSpentAlsoOutside) {
    const auto report = run(python("ask(\"value\", [0.5, 0.5, 0.5])\n"
                                   "assert ask(\"value\", [upper[0] + 1.0, 0.0, 0.0]) == \"spent\"\n"),
                            {.cost = 1});
    EXPECT_EQ(report.ending, Ending::BudgetSpent);
    EXPECT_EQ(report.points_outside, 0);
}

TEST(OutsideCommand, ThatAsksAHundredTimesAfterItsBudgetIsSpentMayStillBeDone) {
    const auto report =
        run(python("for _ in range(102): ask(\"value\", lower)\nprint(\"done\")\n"), {.cost = 1});
    EXPECT_EQ(report.ending, Ending::BudgetSpent);
}

TEST(OutsideCommand, ThatEndsBeforeItIsDoneIsAnErrorWhichNamesIt) {
    EXPECT_THAT(complaint("exit 7"),
                testing::HasSubstr("'exit 7' ended with exit code 7 before it said 'done'"));
    EXPECT_THAT(complaint("no_such_program_here 2>/dev/null"), testing::HasSubstr("exit code 127"));
    EXPECT_THAT(complaint("kill -9 $$"), testing::HasSubstr("exit code 137"));
    EXPECT_THAT(complaint("echo done; exit 3"),
                testing::HasSubstr("said 'done', but ended with exit code 3"));
}

TEST(OutsideCommand, ThatIsDoneWithoutAValueIsAnError) {
    EXPECT_THAT(complaint("echo done"), testing::HasSubstr("said 'done' without asking for a value"));
    EXPECT_THAT(complaint(python("for _ in range(2): ask(\"value\", [upper[0] + 1.0, 0.0, 0.0])\n"
                                 "print(\"done\")\n")),
                testing::HasSubstr("said 'done' without a value; 2 points lay outside of the bounds"));
}

TEST(OutsideCommand, ThatGetsNoValueFromItsBudgetHasNone) {
    const auto report =
        run(python("assert ask(\"value\", [0.0, 0.0, 0.0]) == \"spent\"\n"), {.seconds = 1e-9});
    EXPECT_EQ(report.evaluations, 0);
    EXPECT_EQ(report.ending, Ending::Invalid);
    EXPECT_EQ(report.value, std::numeric_limits<double>::infinity());
    EXPECT_EQ(report.final_point.size(), 0) << "no point of its own making";
}

TEST(OutsideCommand, ThatSaysSomethingElseIsAnErrorWhichQuotesIt) {
    EXPECT_THAT(complaint("echo hello"), testing::HasSubstr("said 'hello'; valid are 'value' or 'gradient'"));
    EXPECT_THAT(complaint("echo; sleep 9"), testing::HasSubstr("said ''"));
    EXPECT_THAT(complaint("echo value 1 2"), testing::HasSubstr("with 2 numbers, where a point has 3"));
    EXPECT_THAT(complaint("echo value 1 x 3"), testing::HasSubstr("said 'value 1 x 3'"));
    EXPECT_THAT(complaint("echo done maybe"), testing::HasSubstr("said 'done maybe'"));
    EXPECT_THAT(complaint("head -c 2000000 /dev/zero"), testing::HasSubstr("mebibyte"));
}

TEST(OutsideCommand, ThatNeverSpeaksIsStopped) {
    int questions = 0;  // the first five are asked while lines are written
    const std::function<bool()> question = [&] { return ++questions > 8; };
    base::Control control;
    control.question = &question;
    EXPECT_THROW((void)run("sleep 1000", {.cost = 10, .control = control}), base::Stopped);
    EXPECT_EQ(questions, 9);
}

TEST(OutsideCommand, MayEndItsLinesInCrLf) {
    const auto report =
        run("head -n 5 >/dev/null; printf \"value 0 0 0\\r\\n\"; read answer; printf \"done\\r\\n\"");
    EXPECT_EQ(report.evaluations, 1);
    EXPECT_EQ(report.ending, Ending::Converged);
}

TEST(OutsideCommand, IsDoneAlsoIfItEndsSlowly) {
    const auto report =
        run(python("ask(\"value\", lower)\n"
                   "print(\"done\", flush=True)\n"
                   "import time\n"
                   "time.sleep(600)\n"));
    EXPECT_EQ(report.ending, Ending::Converged) << "it is killed after a second, which is no error";
}

TEST(OutsideCommand, HasAValidNameAndACommand) {
    for (const char* name : {"", "a,b", "a b", "a=b", "a:2"})
        EXPECT_THROW((void)outside_command_row({name, "true"}), base::InputError) << name;
    EXPECT_THROW((void)outside_command_row({"mine", ""}), base::InputError);
}

}  // namespace THIS_TEST
}  // namespace fretwork::optimization

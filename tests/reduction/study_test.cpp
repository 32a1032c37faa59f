// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"

#include <fretwork/base/files/file.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/methods/outside_command.hpp>
#include <fretwork/optimization/studies/run_table.hpp>
#include <fretwork/optimization/studies/study.hpp>
#include <fretwork/reduction/calibration/study_problems.hpp>

#include <algorithm>
#include <sys/wait.h>
#include <unistd.h>

namespace fretwork::optimization::study {
namespace THIS_TEST {

using optimization::find_optimizer;
using test::TemporaryFolder;

StudyPlan small_plan(const std::string& method) {
    StudyPlan plan;
    plan.families = reduction::study_families();
    plan.problems = {"analytic/beale", "analytic/levy", "analytic/sphere"};
    plan.contenders = {{&find_optimizer(method), 1}};
    plan.conditions.budget.cost = 2000;
    plan.repetitions = 20;
    plan.threads = 1;
    return plan;
}

std::size_t stored_runs(const std::filesystem::path& folder) {
    const auto lines = base::split(base::read_text_file(run_table_path(folder)), '\n');
    return static_cast<std::size_t>(
               std::ranges::count_if(lines, [](const auto& line) { return !line.empty(); })) -
           1;
}

/// Asks to stop once a given number of runs is done.
class StopAfter final : public base::Progress {
  public:
    explicit StopAfter(std::size_t runs) : runs_(runs) {}
    void start(std::string_view, std::size_t) override {}
    void update(std::size_t done) override {
        if (done == runs_) source.request_stop();
    }
    void finish() override {}
    std::stop_source source;

  private:
    std::size_t runs_;
};

TEST(Study, StoresWhatIsDoneWhenItIsStoppedAndGoesOnThere) {
    const TemporaryFolder folder;
    StudyPlan plan = small_plan("bobyqa");
    StopAfter progress(7);
    plan.control = {.stop = progress.source.get_token(), .progress = &progress};
    const StudyReport stopped = run_study(plan, folder.path());
    EXPECT_EQ(stopped.runs_done, 7U);
    EXPECT_EQ(stopped.runs_left_out, 53U);
    EXPECT_EQ(stored_runs(folder.path()), 7U);
    plan.control = {};
    const StudyReport rest = run_study(plan, folder.path());
    EXPECT_EQ(rest.runs_before, 7U);
    EXPECT_EQ(rest.runs_done, 53U);
    EXPECT_EQ(stored_runs(folder.path()), 60U);
}

/// The first run is stored at once, the next ones only after some seconds, or at the end.
TEST(Study, KeepsFinishedRunsWhereAMethodFails) {
    const TemporaryFolder folder;
    StudyPlan plan = small_plan("crs2");
    const OptimizerRow failing = outside_command_row({"failing",
                                                      "read word dimension; [ $dimension = 2 ] || exit 3; "
                                                      "read word lower; read upper; read seed; read starts; "
                                                      "echo value $lower; read answer; echo done"});
    plan.contenders.push_back({&failing, 1});
    EXPECT_THROW(run_study(plan, folder.path()), base::InputError);
    EXPECT_EQ(stored_runs(folder.path()), 3U) << "both of the first problem, and crs2's of the second";
}

TEST(Study, MakesItsFolderBeforeTheFirstRun) {
    const TemporaryFolder folder;
    StudyPlan plan = small_plan("bobyqa");
    plan.repetitions = 1;
    EXPECT_EQ(run_study(plan, folder.path() / "new" / "one").runs_done, 3U);
    EXPECT_EQ(stored_runs(folder.path() / "new" / "one"), 3U);
    base::write_file_atomically(folder.path() / "file", "");
    EXPECT_THROW(run_study(plan, folder.path() / "file"), base::IoError);
}

/// A folder that may not be searched fails alike, but not for the user root.
TEST(Study, RefusesATableThatCannotBeLookedFor) {
    const TemporaryFolder folder;
    std::filesystem::create_symlink("results.csv", run_table_path(folder.path()));
    EXPECT_THROW(run_study(small_plan("bobyqa"), folder.path()), base::IoError);
}

/// Start a process of its own that runs a plan.
pid_t start(const StudyPlan& plan, const std::filesystem::path& folder) {
    const pid_t child = ::fork();
    if (child != 0) return child;
    try {
        run_study(plan, folder);
        ::_exit(0);
    } catch (const std::exception&) {
        ::_exit(1);
    }
}

TEST(Study, KeepsTheRunsOfTwoProcessesInOneFolder) {
    const TemporaryFolder folder;
    const pid_t first = start(small_plan("bobyqa"), folder.path());
    const pid_t second = start(small_plan("crs2"), folder.path());
    for (const pid_t child : {first, second}) {
        int status = -1;
        ::waitpid(child, &status, 0);
        EXPECT_EQ(status, 0);
    }
    EXPECT_EQ(stored_runs(folder.path()), 120U);
}

TEST(Study, SeesTheRunsThatAnotherProcessStoredMeanwhile) {
    const TemporaryFolder folder;
    StudyPlan plan = small_plan("bobyqa");
    // The first of its runs is done when another process stores runs of another method.
    class RunOther final : public base::Progress {
      public:
        explicit RunOther(const std::filesystem::path& folder) : folder_(folder) {}
        void start(std::string_view, std::size_t) override {}
        void update(std::size_t done) override {
            if (done == 1) run_study(small_plan("crs2"), folder_);
        }
        void finish() override {}

      private:
        const std::filesystem::path& folder_;
    } other(folder.path());
    plan.control.progress = &other;
    run_study(plan, folder.path());
    EXPECT_EQ(stored_runs(folder.path()), 120U);
}

TEST(Study, RefusesAPlanThatMakesNoSense) {
    StudyPlan plan = small_plan("bobyqa");
    plan.repetitions = 0;
    const TemporaryFolder folder;
    EXPECT_THROW(run_study(plan, folder.path()), base::InputError);
}

TEST(StudyProblems, OfLayoutsWithSeveralInterfaceNodesASideAreRefused) {
    EXPECT_THAT(test::complaint_of([] {
                    (void)make_study_problem("calibration/doors6:0-1+1-2+1-3+1-4+2-3+3-5",
                                             reduction::study_families());
                }),
                testing::HasSubstr("doors6"));
    EXPECT_NO_THROW((void)make_study_problem("calibration/spider4:0-1+1-3", reduction::study_families()));
}

}  // namespace THIS_TEST
}  // namespace fretwork::optimization::study

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/parallel.hpp>
#include <fretwork/base/task.hpp>

#include <gmock/gmock.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace fretwork::base {
namespace THIS_TEST {

/// Notes all that a task reports.
class Notes final : public Progress {
  public:
    void start(std::string_view task, std::size_t total) override {
        lines.push_back(std::string(task) + " " + std::to_string(total));
    }
    void update(std::size_t done) override { lines.push_back(std::to_string(done)); }
    void finish() override { lines.emplace_back("end"); }
    std::vector<std::string> lines;
};

TEST(Task, EndsAlsoAfterAnException) {
    Notes notes;
    try {
        const Task task({.progress = &notes}, "search", 2);
        task.update(1);
        throw std::runtime_error("");
    } catch (const std::runtime_error&) {
    }
    EXPECT_THAT(notes.lines, testing::ElementsAre("search 2", "1", "end"));
}

TEST(ParallelTask, CountsTheStepsOfAllThreadsInOrder) {
    Notes notes;
    {
        ParallelTask task({.progress = &notes}, "search", 100);
        parallel_for(100, 4, [&](std::size_t) { task.advance(); });
    }
    std::vector<std::string> wanted = {"search 100"};
    for (int done = 1; done <= 100; ++done) wanted.push_back(std::to_string(done));
    wanted.emplace_back("end");
    EXPECT_EQ(notes.lines, wanted);
}

TEST(ParallelTask, ReportsToNobodyIfNobodyListens) {
    ParallelTask task({}, "search", 1);
    EXPECT_NO_THROW(task.advance());
}

}  // namespace THIS_TEST
}  // namespace fretwork::base

// SPDX-License-Identifier: GPL-3.0-or-later
// Several processes at work on one file, and processes that are killed.
#include "cli/command.hpp"
#include "support.hpp"

#include <fretwork/base/file_lock.hpp>
#include <fretwork/base/text.hpp>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <sys/stat.h>
#include <thread>

namespace fretwork::app {
namespace {

using test::run_command;
using test::TemporaryFolder;

/// How many processes wait for a lock on this file, as the kernel tells it.
std::ptrdiff_t waiting_for(const std::filesystem::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return 0;
    const std::string file = ":" + std::to_string(status.st_ino) + " ";
    std::ifstream locks("/proc/locks");
    std::ptrdiff_t count = 0;
    for (std::string line; std::getline(locks, line);)
        count += line.find("-> FLOCK") != std::string::npos && line.find(file) != std::string::npos ? 1 : 0;
    return count;
}

bool comes_true(const std::function<bool()>& condition) {
    constexpr int kMostTries = 6000;  // a minute
    for (int i = 0; i < kMostTries; ++i) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

std::vector<std::string> scratch_in(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().filename().string().starts_with(".fretwork-"))
            names.push_back(entry.path().filename().string());
    }
    return names;
}

class TwoAtOnce : public testing::Test {
  protected:
    test::Outcome run(const std::string& command) { return run_command(command, folder_.path()); }
    TemporaryFolder folder_;
};

TEST_F(TwoAtOnce, LoadCasesThatManyProcessesAddAreAllKept) {
    constexpr int kProcesses = 16;
    ASSERT_EQ(run("fretwork tile experiments/outlines/specimen.svg --edge-length 60mm --patterns 0-1+1-6 "
                  "--out p.json")
                  .exit_code,
              0);
    const std::string load_case = base::read_text_file(folder_.path() / "experiments/cases/own_weight.json");
    for (int i = 0; i < kProcesses; ++i) {
        std::string copy = load_case;
        const std::string key = "\"name\": \"";
        copy.insert(copy.find(key) + key.size(), "number " + std::to_string(i) + " ");
        (void)folder_.file("case" + std::to_string(i) + ".json", copy);
    }
    // All of them stand before the lock before the first gets it.
    auto lock = std::make_unique<base::FileLock>(folder_.path() / "p.json");
    test::Outcome outcome;
    std::thread processes([&] {
        outcome =
            run("for i in $(seq 0 15); do (fretwork case add p.json case$i.json && echo done) & done; wait");
    });
    const bool all_wait = comes_true([&] { return waiting_for(folder_.path() / "p.json") == kProcesses; });
    lock.reset();
    processes.join();
    EXPECT_TRUE(all_wait) << "the processes must be at work at once";
    EXPECT_EQ(std::ranges::count(outcome.out, '\n'), kProcesses) << outcome.err;
    const auto listed = run("fretwork case list p.json");
    EXPECT_EQ(std::ranges::count(listed.out, '\n'), kProcesses) << listed.out;
    EXPECT_TRUE(scratch_in(folder_.path()).empty());
}

TEST_F(TwoAtOnce, PatternsThatManyProcessesAddToANewLibraryAreAllKept) {
    const auto outcome =
        run("for edges in 2 3 4 5; do (fretwork enumerate --edges $edges --library L.db && echo OK) & done; "
            "wait");
    const auto all =
        run("fretwork enumerate --edges 2..5 --library all.db && fretwork library list --library "
            "all.db | grep -c +");
    const auto listed = run("fretwork library list --library L.db | grep -c +");
    EXPECT_EQ(listed.out, all.out.substr(all.out.rfind('\n', all.out.size() - 2) + 1)) << outcome.err;
    EXPECT_EQ(outcome.err, "");
}

TEST_F(TwoAtOnce, WhatAKilledProcessLeftIsRemovedByTheNext) {
    const auto killed =
        run("fretwork enumerate --layout experiments/layouts/fifths12.json --list ids.txt & pid=$!\n"
            "while ! ls .fretwork-* >/dev/null 2>&1; do kill -0 $pid || exit 9; sleep 0.01; done\n"
            "kill -KILL $pid; wait $pid");
    ASSERT_EQ(killed.exit_code, 128 + 9) << "the process must be killed at work";
    ASSERT_EQ(scratch_in(folder_.path()).size(), 1U) << "it must have left something";
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "ids.txt"));
    EXPECT_EQ(run("fretwork enumerate --edges 2 --list other.txt").exit_code, 0);
    EXPECT_TRUE(scratch_in(folder_.path()).empty());
}

TEST_F(TwoAtOnce, AFullDiskLeavesNoLibraryBehind) {
    const auto full = run("trap '' XFSZ; ulimit -f 64; fretwork enumerate --library L.db");
    EXPECT_EQ(full.exit_code, 2);
    EXPECT_THAT(full.err, testing::StartsWith("fretwork: L.db: cannot be "));
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "L.db"));
    EXPECT_TRUE(scratch_in(folder_.path()).empty());
}

TEST_F(TwoAtOnce, ADamagedInputOfAMergeIsNamedAndNothingIsLeft) {
    ASSERT_EQ(run("fretwork enumerate --edges 2..5 --library a.db && cp a.db b.db").exit_code, 0);
    // The schema on the first pages stays whole, the rows behind it do not.
    ASSERT_EQ(run("size=$(stat -c %s b.db); head -c $((size - 20000)) /dev/zero | tr '\\0' x | "
                  "dd of=b.db bs=1 seek=20000 conv=notrunc status=none")
                  .exit_code,
              0);
    const auto outcome = run("fretwork library merge ab.db a.db b.db");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, testing::StartsWith("fretwork: b.db: ")) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "ab.db"));
    EXPECT_TRUE(scratch_in(folder_.path()).empty());
}

}  // namespace
}  // namespace fretwork::app

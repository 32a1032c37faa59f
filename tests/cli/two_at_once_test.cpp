// SPDX-License-Identifier: GPL-3.0-or-later
// Several processes at work on one file, and processes that are killed.
#include "cli/command.hpp"
#include "support.hpp"

#include <fretwork/base/files/file_lock.hpp>
#include <fretwork/base/text.hpp>

#include <algorithm>
#include <chrono>
#include <fcntl.h>
#include <fstream>
#include <functional>
#include <memory>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace fretwork::app {
namespace THIS_TEST {

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

/// How many other processes have this file open.
std::ptrdiff_t users_of(const std::filesystem::path& path) {
    const std::filesystem::path file = std::filesystem::canonical(path);
    std::ptrdiff_t count = 0;
    std::error_code gone;
    for (const auto& process : std::filesystem::directory_iterator("/proc")) {
        const std::string name = process.path().filename();
        // Not "self" and "thread-self", which are this process again.
        if (name.find_first_not_of("0123456789") != std::string::npos || name == std::to_string(::getpid()))
            continue;
        for (std::filesystem::directory_iterator entry(process.path() / "fd", gone), end; entry != end;
             entry.increment(gone)) {
            if (std::filesystem::read_symlink(entry->path(), gone) != file) continue;
            ++count;
            break;
        }
    }
    return count;
}

/// Holds a library as a program does that is about to write: others may read it, and wait before they write.
/// SQLite's file format calls this byte the reserved lock.
class HeldLibrary {
  public:
    explicit HeldLibrary(const std::filesystem::path& path)
        : descriptor_(::open(path.c_str(), O_RDWR | O_CLOEXEC)) {
        struct flock lock {};
        lock.l_type = F_WRLCK;
        lock.l_whence = SEEK_SET;
        lock.l_start = 0x40000001;
        lock.l_len = 1;
        is_held_ = ::fcntl(descriptor_, F_SETLK, &lock) == 0;
    }
    HeldLibrary(const HeldLibrary&) = delete;
    HeldLibrary& operator=(const HeldLibrary&) = delete;
    ~HeldLibrary() { ::close(descriptor_); }
    [[nodiscard]] bool is_held() const { return is_held_; }

  private:
    int descriptor_;
    bool is_held_;
};

class TwoAtOnce : public testing::Test {
  protected:
    test::Outcome run(const std::string& command) { return run_command(command, folder_.path()); }
    /// Run commands at once. None of them writes to the library before all of them have it open.
    test::Outcome run_at_once_on(const std::string& library, const std::vector<std::string>& commands) {
        std::string line;
        for (const std::string& command : commands) line += "(" + command + " && echo DONE) & ";
        const std::filesystem::path path = folder_.path() / library;
        auto held = std::make_unique<HeldLibrary>(path);
        EXPECT_TRUE(held->is_held());
        test::Outcome outcome;
        std::thread processes([&] { outcome = run(line + "wait"); });
        EXPECT_TRUE(comes_true([&] { return users_of(path) == std::ssize(commands); }))
            << "the processes must be at work at once";
        held.reset();
        processes.join();
        EXPECT_EQ(outcome.err, "");
        EXPECT_TRUE(scratch_in(folder_.path()).empty());
        return outcome;
    }
    static std::ptrdiff_t number_done(const test::Outcome& outcome) {
        std::ptrdiff_t count = 0;
        for (const std::string& line : base::split(outcome.out, '\n')) count += line == "DONE" ? 1 : 0;
        return count;
    }
    /// The ids of a library's patterns.
    std::string patterns_of(const std::string& library) {
        return run("fretwork library export --library " + library +
                   " --csv csv && cut -d, -f1 csv/pattern.csv")
            .out;
    }
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
            run("for i in $(seq 0 15); do (fretwork case add p.json case$i.json >out$i && echo done) & "
                "done; wait");
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

TEST_F(TwoAtOnce, AnEmptyFileBecomesALibraryOfAllProcessesThatFindIt) {
    ASSERT_EQ(run("touch L.db && fretwork enumerate --edges 2..5 --library all.db").exit_code, 0);
    const auto outcome = run_at_once_on(
        "L.db",
        {"fretwork enumerate --library L.db --edges 2", "fretwork enumerate --library L.db --edges 3",
         "fretwork enumerate --library L.db --edges 4", "fretwork enumerate --library L.db --edges 5"});
    EXPECT_EQ(number_done(outcome), 4);
    EXPECT_EQ(patterns_of("L.db"), patterns_of("all.db"));
}

TEST_F(TwoAtOnce, CalibrationsAndNewPatternsOfOneLibraryAreAllKept) {
    ASSERT_EQ(run("fretwork enumerate --edges 2 --library L.db").exit_code, 0);
    // By name: "all" is also the new ones, if they are there before a calibration reads the list.
    const std::string ids = run("fretwork library export --library L.db --csv first && "
                                "tail -n +2 first/pattern.csv | cut -d, -f1 | paste -sd, | tr -d '\\n'")
                                .out;
    const auto outcome =
        run_at_once_on("L.db", {"fretwork calibrate --library L.db --starts 1 --patterns " + ids,
                                "fretwork calibrate --library L.db --model condensed --patterns " + ids,
                                "fretwork enumerate --library L.db --edges 3"});
    EXPECT_EQ(number_done(outcome), 3);
    EXPECT_EQ(run("fretwork library list --library L.db | grep -c +").out, "56\n");
    EXPECT_EQ(run("fretwork library export --library L.db --csv csv && cut -d, -f2 csv/calibration.csv | "
                  "sort | uniq -c "
                  "| tr -s ' '")
                  .out,
              " 9 condensed\n 1 model\n 9 paper6\n");
}

TEST_F(TwoAtOnce, ALibraryOfSchema3IsChangedOnceByTwoWriters) {
    std::filesystem::copy_file(std::filesystem::path(FRETWORK_SOURCE_DIR) / "tests/library/data/schema3.db",
                               folder_.path() / "L.db");
    const std::string before = patterns_of("L.db");
    const std::string add = "fretwork enumerate --layout spider4 --library L.db --edges ";
    EXPECT_EQ(number_done(run_at_once_on("L.db", {add + "2", add + "3"})), 2);
    const std::string after = patterns_of("L.db");
    for (const std::string& id : base::split(before, '\n')) EXPECT_THAT(after, testing::HasSubstr(id));
    EXPECT_EQ(run("wc -l <csv/calibration_parameter.csv").out, "13\n")
        << "two calibrations of six parameters";
}

TEST_F(TwoAtOnce, NamesThatDifferInCaseOnlyAreTwoFilesWhereTheFileSystemSaysSo) {
    ASSERT_EQ(run("fretwork enumerate --edges 2 --list a.txt --census A.csv --classes a.csv").exit_code, 0);
    EXPECT_EQ(run("ls a.txt A.csv a.csv | wc -l").out, "3\n");
    EXPECT_EQ(run("fretwork enumerate --edges 2 --census a.csv --classes ./a.csv").exit_code, 2);
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

// A kilobyte, in place of a full disk: what is written is larger, and the messages are not.
TEST_F(TwoAtOnce, AFullDiskIsToldByEveryVerbAndLeavesNothing) {
    ASSERT_EQ(run("fretwork enumerate --edges 2..3 --library L.db && "
                  "fretwork tile experiments/outlines/specimen.svg --edge-length 60mm --patterns 0-1+1-6 "
                  "--out p.json && "
                  "fretwork case add p.json experiments/cases/cantilever.json && "
                  "fretwork simulate p.json --case cantilever --out r.json --frame-out f.json && mkdir new")
                  .exit_code,
              0);
    const std::string before = run("cat L.db p.json r.json f.json | sha256sum").out;
    for (const std::string command :
         {"fretwork enumerate --list new/l.txt", "fretwork enumerate --svg new/s.svg --edges 3",
          "fretwork enumerate --classes new/k.csv", "fretwork enumerate --edges 4..5 --library L.db",
          "fretwork enumerate --library new/L.db",
          "fretwork calibrate --library L.db --patterns sample:2 --starts 1",
          "fretwork library merge new/m.db L.db", "fretwork library export --library L.db --csv new/t",
          "fretwork library export --library L.db --meshes new/m --svg new/s.svg",
          "fretwork tile experiments/outlines/specimen.svg --edge-length 60mm --out new/p.json",
          "fretwork case add p.json experiments/cases/own_weight.json",
          "fretwork simulate p.json --case cantilever --out new/r.json --vtu new/r.vtu",
          "fretwork solve f.json --out new/r.json", "fretwork export p.json --to new/x.svg --to new/x.obj",
          "fretwork optimizers known --patterns 1 --starts 1 --out new/k.csv"}) {
        const auto full = run("( trap '' XFSZ; ulimit -f 1; exec " + command + ")");
        EXPECT_EQ(full.exit_code, 2) << command << "\n" << full.err;
        EXPECT_EQ(std::ranges::count(full.err, '\n'), 1) << command << "\n" << full.err;
        EXPECT_EQ(run("find new -mindepth 1 -not -name t -not -name m").out, "") << command;
        EXPECT_TRUE(scratch_in(folder_.path()).empty()) << command;
    }
    EXPECT_EQ(run("cat L.db p.json r.json f.json | sha256sum").out, before);
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

}  // namespace THIS_TEST
}  // namespace fretwork::app

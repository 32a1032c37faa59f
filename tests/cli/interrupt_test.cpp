// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl-C in the middle of work: what is stored, and that nothing else is left behind.
#include "cli/command.hpp"
#include "support.hpp"

#include <fretwork/base/text.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <functional>
#include <sys/stat.h>
#include <thread>
#include <vector>

namespace fretwork::app {
namespace THIS_TEST {

using test::TemporaryFolder;

constexpr int kLongerThanAnyMachineNeeds = 60;  // s

/// Look every few milliseconds until something is so.
bool comes_true(const std::function<bool()>& is_so) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(kLongerThanAnyMachineNeeds);
    while (std::chrono::steady_clock::now() < end) {
        if (is_so()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return false;
}

/// The program in a process of its own, in a folder.
class Running {
  public:
    Running(const std::filesystem::path& folder, std::vector<std::string> arguments,
            void (*on_interrupt)(int) = SIG_DFL)
        : folder_(folder) {
        arguments.insert(arguments.begin(), FRETWORK_PROGRAM);
        std::vector<char*> pointers;
        for (std::string& argument : arguments) pointers.push_back(argument.data());
        pointers.push_back(nullptr);
        const std::string messages = (folder / ".err").string();
        child_ = ::fork();
        if (child_ != 0) return;
        std::signal(SIGINT, on_interrupt);  // the tests themselves may run in the background
        ::close(STDOUT_FILENO);
        ::open((folder / ".out").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        ::close(STDERR_FILENO);
        ::open(messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        if (::chdir(folder.c_str()) == 0) ::execv(pointers.front(), pointers.data());
        ::_exit(127);
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    ~Running() {
        if (child_ <= 0) return;
        ::kill(child_, SIGKILL);
        ::waitpid(child_, nullptr, 0);
    }

    [[nodiscard]] bool is_at_work() const { return ::waitpid(child_, nullptr, WNOHANG) == 0; }
    void signal(int number) const { ::kill(child_, number); }
    /// How it ended: waitpid's status.
    int wait() {
        int status = -1;
        ::waitpid(std::exchange(child_, -1), &status, 0);
        return status;
    }
    /// A number that the kernel tells of the process, in hexadecimal where it does.
    [[nodiscard]] unsigned long long status(const std::string& name, int radix) const {
        std::ifstream lines("/proc/" + std::to_string(child_) + "/status");
        for (std::string line; std::getline(lines, line);) {
            if (line.starts_with(name + ":"))
                return std::stoull(line.substr(name.size() + 1), nullptr, radix);
        }
        return 0;
    }
    [[nodiscard]] bool catches(int number) const {
        return (status("SigCgt", 16) >> static_cast<unsigned>(number - 1) & 1U) != 0;
    }
    [[nodiscard]] bool ignores(int number) const {
        return (status("SigIgn", 16) >> static_cast<unsigned>(number - 1) & 1U) != 0;
    }
    [[nodiscard]] bool has_one_thread() const { return status("Threads", 10) == 1; }
    [[nodiscard]] bool has_open(const std::filesystem::path& path) const {
        const std::filesystem::path file = std::filesystem::canonical(path);
        std::error_code gone;
        for (std::filesystem::directory_iterator entry("/proc/" + std::to_string(child_) + "/fd", gone), end;
             entry != end; entry.increment(gone)) {
            if (std::filesystem::read_symlink(entry->path(), gone) == file) return true;
        }
        return false;
    }
    [[nodiscard]] std::string messages() const { return base::read_text_file(folder_ / ".err"); }

  private:
    std::filesystem::path folder_;
    pid_t child_ = -1;
};

/// The files of a folder that are no messages of the program.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (name != ".out" && name != ".err") files.push_back(entry.path());
    }
    return files;
}

bool has_content(const std::vector<std::filesystem::path>& files) {
    return std::ranges::any_of(files, [](const auto& path) {
        std::error_code gone;
        const auto size = std::filesystem::file_size(path, gone);
        return !gone && size > 0;
    });
}

TEST(Interrupt, LeavesNothingOfAListThatIsBeingWritten) {
    for (const int signal : {SIGINT, SIGTERM}) {
        const TemporaryFolder folder;
        Running program(folder.path(), {"enumerate", "--layout", "fifths12", "--list", "huge.txt"});
        ASSERT_TRUE(comes_true([&] { return has_content(files_in(folder.path())); }));
        ASSERT_TRUE(program.is_at_work()) << program.messages();
        program.signal(signal);
        const int status = program.wait();
        ASSERT_TRUE(WIFEXITED(status));
        EXPECT_EQ(WEXITSTATUS(status), 1);
        EXPECT_EQ(program.messages(), "fretwork: stopped before it was done; nothing is half-written\n");
        EXPECT_THAT(files_in(folder.path()), testing::IsEmpty());
    }
}

TEST(Interrupt, IsIgnoredInABackgroundJobOfAScript) {
    const TemporaryFolder folder;
    Running program(folder.path(), {"enumerate", "--layout", "fifths12", "--list", "huge.txt"}, SIG_IGN);
    ASSERT_TRUE(comes_true([&] { return has_content(files_in(folder.path())); }));
    EXPECT_TRUE(program.ignores(SIGINT));
    EXPECT_TRUE(program.catches(SIGTERM));
}

/// A named pipe in the place of a file, of which a reader gets nothing before it is filled.
class SlowFile {
  public:
    explicit SlowFile(const std::filesystem::path& file) : content_(base::read_text_file(file)) {
        std::filesystem::remove(file);
        ::mkfifo(file.c_str(), 0600);
        descriptor_ = ::open(file.c_str(), O_RDWR | O_CLOEXEC);
    }
    SlowFile(const SlowFile&) = delete;
    SlowFile& operator=(const SlowFile&) = delete;
    ~SlowFile() { fill(); }
    void fill() {
        if (descriptor_ < 0) return;
        EXPECT_EQ(::write(descriptor_, content_.data(), content_.size()), std::ssize(content_));
        ::close(std::exchange(descriptor_, -1));
    }

  private:
    std::string content_;
    int descriptor_ = -1;
};

TEST(Interrupt, ThatComesWhileTheInputIsReadStopsBeforeAnythingIsWritten) {
    const TemporaryFolder folder;
    ASSERT_EQ(
        test::run_command("fretwork tile experiments/outlines/specimen.svg --edge-length 60mm --patterns "
                          "0-1+1-6 --out p.json && fretwork simulate p.json --case "
                          "experiments/cases/cantilever.json --out r.json --frame-out f.json && rm r.json",
                          folder.path())
            .exit_code,
        0);
    SlowFile input(folder.path() / "f.json");
    const std::size_t before = files_in(folder.path()).size();
    Running program(folder.path(), {"solve", "f.json", "--out", "new.json", "--vtu", "new.vtu"});
    ASSERT_TRUE(comes_true([&] { return program.catches(SIGINT); }));
    // Bytes in a pipe that nobody has open yet are lost; and then the thread that waits is there,
    // too.
    ASSERT_TRUE(comes_true([&] { return program.has_open(folder.path() / "f.json"); }));
    program.signal(SIGINT);
    // The thread that waits for the signal has asked for the stop when it ends.
    ASSERT_TRUE(comes_true([&] { return program.has_one_thread(); }));
    input.fill();
    const int status = program.wait();
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 1);
    EXPECT_EQ(program.messages(), "fretwork: stopped before it was done; nothing is half-written\n");
    EXPECT_EQ(files_in(folder.path()).size(), before);
}

TEST(Interrupt, StopsATilingAndLeavesNoFile) {
    const TemporaryFolder folder;
    const std::string outline = FRETWORK_SOURCE_DIR "/experiments/outlines/specimen.svg";
    // Tiles of 1 mm: 18,000 of them, which takes minutes.
    Running program(folder.path(), {"tile", outline, "--edge-length", "1mm", "--out", "p.json"});
    ASSERT_TRUE(comes_true([&] { return program.catches(SIGINT); }));
    program.signal(SIGINT);
    const int status = program.wait();
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 1);
    EXPECT_EQ(program.messages(), "fretwork: stopped before it was done; nothing is half-written\n");
    EXPECT_THAT(files_in(folder.path()), testing::IsEmpty());
}

class InterruptOfDesign : public testing::Test {
  protected:
    void SetUp() override {
        folder_.file("t.json", R"({"format": "fretwork/target/1", "goals": [
            {"select": {"side": "right"}, "displacement": [null, null, -0.003]}]})");
        ASSERT_EQ(test::run_command("fretwork tile experiments/outlines/specimen.svg --edge-length 40mm "
                                    "--out p.json && "
                                    "fretwork case add p.json experiments/cases/cantilever.json",
                                    folder_.path())
                      .exit_code,
                  0);
    }
    TemporaryFolder folder_;
};

/// Before the work begins as well as in it: by exit code, and never by the signal.
TEST_F(InterruptOfDesign, EndsWithTheExitCodeFromItsBeginning) {
    for (const int signal : {SIGINT, SIGTERM}) {
        Running program(folder_.path(), {"design", "p.json", "--target", "t.json", "--out", "d.json"});
        ASSERT_TRUE(comes_true([&] { return program.catches(signal); }));
        program.signal(signal);
        const int status = program.wait();
        ASSERT_TRUE(WIFEXITED(status)) << "killed by signal " << WTERMSIG(status);
        EXPECT_EQ(WEXITSTATUS(status), 1);
        EXPECT_EQ(program.messages(), "fretwork: stopped before it was done; nothing is half-written\n");
        EXPECT_FALSE(std::filesystem::exists(folder_.path() / "d.json"));
    }
}

/// Verbs of a moment have no work that could be asked to stop: the program waits for the pipe here.
TEST_F(InterruptOfDesign, EndsShortVerbsWithTheExitCodeToo) {
    const SlowFile project(folder_.path() / "p.json");
    Running program(folder_.path(), {"case", "list", "p.json"});
    ASSERT_TRUE(comes_true([&] { return program.catches(SIGTERM); }));
    program.signal(SIGTERM);
    const int status = program.wait();
    ASSERT_TRUE(WIFEXITED(status)) << "killed by signal " << WTERMSIG(status);
    EXPECT_EQ(WEXITSTATUS(status), 1);
    EXPECT_EQ(program.messages(), "fretwork: stopped before it was done; nothing is half-written\n");
}

/// No file is half-written before the work begins, so the program does not wait for its input.
TEST_F(InterruptOfDesign, EndsASimulationThatStillReads) {
    const SlowFile project(folder_.path() / "p.json");
    Running program(folder_.path(), {"simulate", "p.json", "--case", "cantilever", "--out", "r.json"});
    ASSERT_TRUE(
        comes_true([&] { return program.catches(SIGINT) && program.has_open(folder_.path() / "p.json"); }));
    program.signal(SIGINT);
    const int status = program.wait();
    ASSERT_TRUE(WIFEXITED(status)) << "killed by signal " << WTERMSIG(status);
    EXPECT_EQ(WEXITSTATUS(status), 1);
    EXPECT_EQ(program.messages(), "fretwork: stopped before it was done; nothing is half-written\n");
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "r.json"));
}

/// Who sends SIGTERM again and again does not lose what is found: a person alone ends it at once.
TEST_F(InterruptOfDesign, ASecondTermIsNoSecondCtrlC) {
    SlowFile target(folder_.path() / "t.json");
    Running program(folder_.path(), {"design", "p.json", "--target", "t.json", "--out", "d.json"});
    ASSERT_TRUE(comes_true([&] { return program.catches(SIGTERM); }))
        << "it runs: before, it has this file, too";
    ASSERT_TRUE(comes_true([&] { return program.has_open(folder_.path() / "t.json"); }));
    program.signal(SIGTERM);
    ASSERT_TRUE(comes_true([&] { return program.has_one_thread(); }));
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    program.signal(SIGTERM);
    target.fill();
    const int status = program.wait();
    ASSERT_TRUE(WIFEXITED(status)) << "killed by signal " << WTERMSIG(status);
    EXPECT_EQ(WEXITSTATUS(status), 1);
}

TEST(Interrupt, OfACalibrationLeavesAWholeLibraryWithWhatIsDone) {
    const TemporaryFolder folder;
    const auto run = [&](const std::string& command) { return test::run_command(command, folder.path()); };
    ASSERT_EQ(run("fretwork enumerate --library lib.db").exit_code, 0);
    const auto library = folder.path() / "lib.db";
    const auto before = std::filesystem::last_write_time(library);
    // 1,824 patterns with 64 starts take minutes; what is done is stored every second.
    Running program(folder.path(), {"calibrate", "--library", "lib.db", "--starts", "64", "--json"});
    ASSERT_TRUE(comes_true([&] { return std::filesystem::last_write_time(library) != before; }));
    ASSERT_TRUE(program.is_at_work()) << program.messages();
    program.signal(SIGINT);
    const int status = program.wait();
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 1);
    EXPECT_THAT(base::read_text_file(folder.path() / ".out"), testing::HasSubstr("\"interrupted\": true"));
    EXPECT_EQ(program.messages(), "fretwork: interrupted; what is done is stored, run again to go on\n");
    EXPECT_EQ(run("sqlite3 lib.db 'PRAGMA integrity_check'").out, "ok\n");
    EXPECT_NE(run("sqlite3 lib.db 'SELECT count(*) FROM calibration'").out, "0\n");
}

TEST(Interrupt, StoresTheRunsOfAStudyThatAreDone) {
    const TemporaryFolder folder;
    (void)folder.file("known.csv", "problem,best_value,scale,found_by\nanalytic/levy,0,1,construction\n");
    Running program(folder.path(), {"optimizers", "run", "--known", "known.csv", "--repetitions", "1000000",
                                    "--optimizers", "random-search", "--budget", "2000", "--out", "runs"});
    const auto table = folder.path() / "runs" / "results.csv";
    ASSERT_TRUE(comes_true([&] { return std::filesystem::exists(table); }));
    ASSERT_TRUE(program.is_at_work()) << program.messages();
    program.signal(SIGINT);
    const int status = program.wait();
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 1);
    EXPECT_THAT(program.messages(), testing::HasSubstr("what is done is stored"));
    EXPECT_GT(base::split(base::read_text_file(table), '\n').size(), 2U);
    EXPECT_EQ(files_in(folder.path() / "runs").size(), 1U) << "nothing but the table";
}

}  // namespace THIS_TEST
}  // namespace fretwork::app

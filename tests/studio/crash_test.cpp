// SPDX-License-Identifier: GPL-3.0-or-later
// The program as its user starts it, and as the machine may end it.
#include "running_studio.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <map>
#include <sys/wait.h>

namespace fretwork::studio {
namespace THIS_TEST {

/// `fretwork studio` in a process of its own.
class Program {
  public:
    enum class Opens { Project, Nothing };
    explicit Program(const std::filesystem::path& folder, Opens opens = Opens::Project,
                     const std::map<std::string, std::string>& environment = {}) {
        int ends[2];
        if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
        child_ = ::fork();
        if (child_ == 0) {
            ::dup2(ends[1], STDOUT_FILENO);
            ::setenv("XDG_STATE_HOME", folder.c_str(), 1);
            for (const auto& [name, value] : environment) ::setenv(name.c_str(), value.c_str(), 1);
            const std::string project = folder / "project.json";
            ::execl(FRETWORK_PROGRAM, "fretwork", "studio", "--no-browser",
                    opens == Opens::Project ? project.c_str() : nullptr, nullptr);
            ::_exit(127);
        }
        ::close(ends[1]);
        char c = 0;
        while (::read(ends[0], &c, 1) == 1 && c != '\n') address_ += c;
        ::close(ends[0]);
    }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    ~Program() { end(SIGKILL); }

    [[nodiscard]] const std::string& address() const { return address_; }
    /// Its exit code; -1 after a signal that ended it.
    int end(int signal) {
        if (child_ <= 0) return -1;
        ::kill(child_, signal);
        int status = 0;
        ::waitpid(std::exchange(child_, -1), &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

  private:
    pid_t child_ = -1;
    std::string address_;
};

TEST(StudioProgram, PrintsItsAddressAtOnceAndEndsWhenItIsAsked) {
    const test::TemporaryFolder folder;
    simulation::write_project(test::studio_project(), folder.path() / "project.json");
    Program program(folder.path());
    const test::StudioAddress address(program.address());
    EXPECT_EQ(test::status_of(test::http(address.port, test::get_request("/?token=" + address.token))), 200);
    EXPECT_EQ(program.end(SIGTERM), 0);
}

TEST(StudioProgram, LosesNothingWhenItsTerminalIsClosed) {
    const test::TemporaryFolder folder;
    simulation::write_project(test::studio_project(), folder.path() / "project.json");
    Program program(folder.path());
    test::Client client(test::StudioAddress(program.address()));
    client.hello();
    std::string text;
    for (int turns = 1; turns <= 3; ++turns) {  // the last ones wait for the pause after the first
        ASSERT_TRUE(client.ask("turn", {{"tiles", {1}}, {"by", 1}})["ok"].get<bool>());
        text = client.ask("download")["text"].get<std::string>();
    }
    EXPECT_EQ(program.end(SIGHUP), 0);
    Program again(folder.path());
    test::Client reader(test::StudioAddress(again.address()));
    reader.hello();
    EXPECT_EQ(reader.ask("download")["text"], text);
}

TEST(StudioProgram, StartsWithoutAutosaveWhereItsFolderCannotBeMade) {
    const test::TemporaryFolder folder;
    simulation::write_project(test::studio_project(), folder.path() / "project.json");
    std::ofstream(folder.path() / "fretwork") << "a file where the folder is to be";
    for (const auto opens : {Program::Opens::Nothing, Program::Opens::Project}) {
        Program program(folder.path(), opens);
        ASSERT_NE(program.address(), "");
        test::Client client(test::StudioAddress(program.address()));
        client.hello();
        const base::Json warning = client.event({"warning"});
        EXPECT_THAT(warning["text"].get<std::string>(),
                    testing::HasSubstr("changes that are not saved are lost"));
        EXPECT_TRUE(warning["revision"].is_number_integer()) << warning;
        if (opens == Program::Opens::Nothing) continue;
        EXPECT_TRUE(client.ask("turn", {{"tiles", {1}}, {"by", 1}})["ok"].get<bool>());
        EXPECT_TRUE(client.ask("save")["ok"].get<bool>());
        const auto other = (folder.path() / "other.json").string();
        EXPECT_TRUE(client.ask("save", {{"path", other}})["ok"].get<bool>());
        EXPECT_TRUE(client.ask("open", {{"path", other}, {"discard", true}})["ok"].get<bool>());
        EXPECT_EQ(program.end(SIGTERM), 0);
    }
}

TEST(StudioProgram, OutlivesAFolderForTemporaryFilesThatIsNotThere) {
    const test::TemporaryFolder folder;
    simulation::write_project(test::studio_project(), folder.path() / "project.json");
    Program program(folder.path(), Program::Opens::Project, {{"TMPDIR", folder.path() / "nowhere"}});
    test::Client client(test::StudioAddress(program.address()));
    client.hello();
    const base::Json answer =
        client.ask("measure", {{"outline", {{"name", "square.json"}, {"text_base64", ""}}}});
    EXPECT_FALSE(answer["ok"].get<bool>());
    EXPECT_THAT(answer["error"].get<std::string>(), testing::HasSubstr("TMPDIR"));
    EXPECT_EQ(program.end(SIGTERM), 0);
}

TEST(StudioProgram, LosesNothingOfWhatWasKeptWhenItIsKilled) {
    const test::TemporaryFolder folder;
    simulation::write_project(test::studio_project(), folder.path() / "project.json");
    std::string text;
    {
        Program program(folder.path());
        test::Client client(test::StudioAddress(program.address()));
        client.hello();
        ASSERT_TRUE(client.ask("paint", {{"tiles", {1}}, {"pattern", "0-5+5-6"}})["ok"].get<bool>());
        text = client.ask("download")["text"].get<std::string>();
        // It is written soon, and this waits for the file, not for a time.
        const auto kept = folder.path() / "fretwork";
        const auto is_kept = [&] {
            if (!std::filesystem::exists(kept)) return false;
            for (const auto& entry : std::filesystem::recursive_directory_iterator(kept)) {
                if (entry.path().extension() == ".json") return true;
            }
            return false;
        };
        while (!is_kept()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
        EXPECT_EQ(program.end(SIGKILL), -1);
    }
    {
        const Program without(folder.path(), Program::Opens::Nothing);
        test::Client client(test::StudioAddress(without.address()));
        const auto hello = client.ask("hello", {{"protocol", 1}});
        ASSERT_EQ(hello["recoverable"].size(), 1U) << "it is offered without naming the file";
        EXPECT_EQ(hello["recoverable"][0]["name"], "project");
    }
    Program program(folder.path());
    test::Client client(test::StudioAddress(program.address()));
    client.hello();
    EXPECT_TRUE(client.event({"document"})["recovered"].get<bool>());
    EXPECT_EQ(client.ask("download")["text"], text);
}

}  // namespace THIS_TEST
}  // namespace fretwork::studio

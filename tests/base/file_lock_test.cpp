// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"

#include <fretwork/base/files/file_lock.hpp>

#include <csignal>
#include <sys/wait.h>
#include <vector>

namespace fretwork::base {
namespace THIS_TEST {

using test::TemporaryFolder;

/// A process of its own that runs `action` and ends.
template <class Action>
pid_t start(Action&& action) {
    const pid_t child = ::fork();
    if (child != 0) return child;
    try {
        action();
        ::_exit(0);
    } catch (const Error&) {
        ::_exit(1);
    }
}

bool succeeded(pid_t child) {
    int status = 0;
    return ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST(FileLock, IsRefusedWhileAnotherHoldsIt) {
    const TemporaryFolder folder;
    for (const auto& path : {folder.file("x", "text"), folder.path()}) {
        {
            const FileLock held(path);
            EXPECT_FALSE(FileLock::try_lock(path)) << path;
        }
        EXPECT_TRUE(FileLock::try_lock(path)) << path;
    }
}

TEST(FileLock, HoldsTheFileThatIsAtThePathNow) {
    const TemporaryFolder folder;
    const auto path = folder.file("x", "old");
    const FileLock of_old(path);
    write_file_atomically(path, "new");
    const auto of_new = FileLock::try_lock(path);
    ASSERT_TRUE(of_new);
    EXPECT_FALSE(FileLock::try_lock(path));
}

TEST(FileLock, OfAMissingFileIsRefused) {
    EXPECT_THROW(FileLock("nowhere/x"), InputError);
}

// Without the lock, processes that start at once read the same number and most changes are lost.
TEST(FileLock, ChangesOfManyProcessesAreAllKept) {
    constexpr int kProcesses = 8;
    constexpr int kChanges = 20;
    const TemporaryFolder folder;
    const auto path = folder.file("count", "0");
    std::vector<pid_t> children;
    for (int i = 0; i < kProcesses; ++i) {
        children.push_back(start([&] {
            for (int change = 0; change < kChanges; ++change) {
                const FileLock lock(path);
                write_file_atomically(path, std::to_string(std::stoi(read_text_file(path)) + 1));
            }
        }));
    }
    for (const pid_t child : children) EXPECT_TRUE(succeeded(child));
    EXPECT_EQ(read_text_file(path), std::to_string(kProcesses * kChanges));
}

TEST(FileLock, EndsWithAKilledHolder) {
    const TemporaryFolder folder;
    const auto path = folder.file("x", "text");
    int ready[2];
    ASSERT_EQ(::pipe(ready), 0);
    const pid_t holder = start([&] {
        const FileLock lock(path);
        (void)!::write(ready[1], "l", 1);
        ::pause();
    });
    char letter = 0;
    ASSERT_EQ(::read(ready[0], &letter, 1), 1);
    EXPECT_FALSE(FileLock::try_lock(path)) << "the holder must be at work when it is killed";
    ::kill(holder, SIGKILL);
    int status = 0;
    ::waitpid(holder, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_TRUE(FileLock::try_lock(path));
    ::close(ready[0]);
    ::close(ready[1]);
}

}  // namespace THIS_TEST
}  // namespace fretwork::base

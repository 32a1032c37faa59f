// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <future>
#include <limits>
#include <string>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace fretwork::base {
namespace THIS_TEST {

using test::complaint_of;
using test::TemporaryFolder;
using testing::HasSubstr;

std::size_t entries(const std::filesystem::path& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

TEST(File, HasAnEndingInSmallLetters) {
    EXPECT_EQ(ending_of("a.b/Chair.SVG"), ".svg");
    EXPECT_EQ(ending_of("chair"), "");
    EXPECT_EQ(ending_of("x.tar.Gz"), ".gz");
}

TEST(File, ReadsBackWhatWasWritten) {
    const TemporaryFolder folder;
    const std::string content("a\0b\r\nc", 6);
    write_file_atomically(folder.path() / "x", content);
    EXPECT_EQ(read_text_file(folder.path() / "x"), content);
}

TEST(File, ReplacingKeepsPermissionsAndLeavesNothingBeside) {
    const TemporaryFolder folder;
    const auto path = folder.file("x", "old");
    std::filesystem::permissions(path,
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    write_file_atomically(path, "new");
    EXPECT_EQ(read_text_file(path), "new");
    EXPECT_EQ(std::filesystem::status(path).permissions(),
              std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(File, AFileThatNobodyMayWriteIsNotReplaced) {
    const TemporaryFolder folder;
    const auto path = folder.file("b", "old");
    ASSERT_EQ(::chmod(path.c_str(), 0444), 0);
    EXPECT_THAT(complaint_of([&] { write_file_atomically(path, "new"); }),
                HasSubstr("b: is protected: nobody may write it"));
    FolderBatch files(folder.path());
    for (const char* name : {"a", "b", "c"}) files.add(name, "new");
    EXPECT_THROW(files.commit(), IoError);
    EXPECT_EQ(read_text_file(path), "old");
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "a"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "c"));
    ASSERT_EQ(::chmod(path.c_str(), 0644), 0);
    write_file_atomically(path, "new");
    EXPECT_EQ(read_text_file(path), "new");
}

/// Only root may give files away: without root, the owner is one's own before and after.
TEST(File, ReplacingKeepsTheOwnerAndTheGroup) {
    const TemporaryFolder folder;
    const auto status_of = [](const std::filesystem::path& path) {
        struct stat status {};
        EXPECT_EQ(::stat(path.c_str(), &status), 0);
        return status;
    };
    constexpr uid_t kOther = 65534;
    for (const char* name : {"alone", "batch"}) {
        const auto path = folder.file(name, "old");
        const int given = ::chown(path.c_str(), kOther, kOther);
        EXPECT_TRUE(given == 0 || ::getuid() != 0 || errno == EINVAL || errno == EPERM);
        ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
    }
    const auto alone = status_of(folder.path() / "alone");
    const auto batch = status_of(folder.path() / "batch");
    write_file_atomically(folder.path() / "alone", "new");
    FolderBatch files(folder.path());
    files.add("batch", "new");
    files.commit();
    EXPECT_EQ(read_text_file(folder.path() / "alone"), "new");
    EXPECT_EQ(read_text_file(folder.path() / "batch"), "new");
    EXPECT_EQ(status_of(folder.path() / "alone").st_uid, alone.st_uid);
    EXPECT_EQ(status_of(folder.path() / "alone").st_gid, alone.st_gid);
    EXPECT_EQ(status_of(folder.path() / "alone").st_mode & 0777U, 0640U);
    EXPECT_EQ(status_of(folder.path() / "batch").st_uid, batch.st_uid);
    EXPECT_EQ(status_of(folder.path() / "batch").st_gid, batch.st_gid);
}

/// A race: without a lock, this fails often, but not always.
TEST(File, ThreadsThatWriteNewFilesLeaveTheUmaskAlone) {
    constexpr mode_t kMask = 022;
    const TemporaryFolder folder;
    const mode_t before = ::umask(kMask);
    {
        std::vector<std::jthread> threads;
        for (int t = 0; t < 4; ++t) {
            threads.emplace_back([&folder, t] {
                const std::string name = std::to_string(t) + "-";
                for (int i = 0; i < 50; ++i)
                    write_file_atomically(folder.path() / (name + std::to_string(i)), "new");
            });
        }
    }
    EXPECT_EQ(::umask(before), kMask);
}

TEST(File, AMissingFileAndAFolderAreRefusedByName) {
    const TemporaryFolder folder;
    EXPECT_THAT(complaint_of([&] { read_text_file(folder.path() / "none.json"); }), HasSubstr("none.json"));
    EXPECT_THAT(complaint_of([&] { read_text_file(folder.path()); }), HasSubstr("is a folder"));
}

TEST(File, AFolderThatIsMissingCannotBeWrittenTo) {
    const TemporaryFolder folder;
    EXPECT_THROW(write_file_atomically(folder.path() / "none" / "x", "text"), IoError);
    EXPECT_THROW(write_file_atomically(folder.path(), "text"), IoError);
}

TEST(File, AFullDiskIsReported) {
    EXPECT_THROW(write_file_atomically("/dev/full", "text"), IoError);
}

/// A limit on the size of files stands for a full disk: write() fails after the first bytes.
TEST(File, AFailedWriteLeavesTheOldFileAndNothingElse) {
    const TemporaryFolder folder;
    const auto path = folder.file("x", "old");
    const pid_t child = ::fork();
    if (child == 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{1000, 1000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        try {
            write_file_atomically(path, std::string(100000, 'n'));
        } catch (const IoError&) {
            ::_exit(0);
        }
        ::_exit(1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    EXPECT_EQ(read_text_file(path), "old");
    EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(File, ADeviceWithoutAnEndIsRefused) {
    for (const char* device : {"/dev/zero", "/dev/null"})
        EXPECT_THAT(complaint_of([&] { read_text_file(device); }), HasSubstr("is a device"));
}

/// A file in memory, because not every file system has files of this size.
TEST(File, AHugeFileOfHolesIsRefused) {
    const int huge = ::memfd_create("huge", MFD_CLOEXEC);
    ASSERT_GE(huge, 0);
    ASSERT_EQ(::ftruncate(huge, std::numeric_limits<off_t>::max()), 0);
    EXPECT_THAT(complaint_of([&] { read_text_file("/proc/self/fd/" + std::to_string(huge)); }),
                HasSubstr("is too large for the memory: 9223372036854775807 bytes"));
    ::close(huge);
}

TEST(File, WritingThroughALinkReplacesWhatItLeadsTo) {
    const TemporaryFolder folder;
    const auto target = folder.file("target", "old");
    std::filesystem::create_symlink("target", folder.path() / "link");
    std::filesystem::create_symlink("link", folder.path() / "link of link");
    std::filesystem::create_symlink("not there yet", folder.path() / "dangling");
    write_file_atomically(folder.path() / "link of link", "new");
    write_file_atomically(folder.path() / "dangling", "made");
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link of link"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link"));
    EXPECT_EQ(read_text_file(target), "new");
    EXPECT_EQ(read_text_file(folder.path() / "not there yet"), "made");
}

TEST(File, ACircleOfLinksIsRefused) {
    const TemporaryFolder folder;
    std::filesystem::create_symlink("b", folder.path() / "a");
    std::filesystem::create_symlink("a", folder.path() / "b");
    EXPECT_THROW((void)read_text_file(folder.path() / "a"), InputError);
}

TEST(FolderBatch, MakesItsFolderWithAllFilesOrNone) {
    const TemporaryFolder folder;
    const auto made = folder.path() / "new" / "nested";
    {
        FolderBatch given_up(made);
        given_up.add("a", "1");
    }
    EXPECT_EQ(entries(folder.path()), 0U);
    FolderBatch batch(made);
    batch.add("a", "1");
    batch.add("b", "2");
    batch.commit();
    EXPECT_EQ(entries(made), 2U);
    EXPECT_EQ(read_text_file(made / "b"), "2");
}

TEST(FolderBatch, KeepsTheOtherFilesOfItsFolder) {
    const TemporaryFolder folder;
    (void)folder.file("mine", "kept");
    (void)folder.file("a", "old");
    FolderBatch batch(folder.path());
    batch.add("a", "new");
    EXPECT_EQ(read_text_file(folder.path() / "a"), "old");
    batch.commit();
    EXPECT_EQ(read_text_file(folder.path() / "a"), "new");
    EXPECT_EQ(read_text_file(folder.path() / "mine"), "kept");
}

TEST(FileBatch, WritesAllOrNothing) {
    const TemporaryFolder folder;
    FileBatch fails;
    fails.add(folder.path() / "first", "1");
    fails.add("/dev/full", "2");
    EXPECT_THROW(fails.commit(), IoError);
    FileBatch works;
    works.add(folder.path() / "second", "2");
    works.add(folder.path() / "third", "3");
    works.commit();
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "first"));
    EXPECT_EQ(read_text_file(folder.path() / "second"), "2");
    EXPECT_EQ(read_text_file(folder.path() / "third"), "3");
}

TEST(AtomicFile, AppearsWholeWhenItIsCommittedAndNotBefore) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "x";
    const std::string piece(1000, 'p');
    AtomicFile file(path);
    std::string whole;
    for (int i = 0; i < 200; ++i) {
        file.write(piece);
        whole += piece;
    }
    EXPECT_FALSE(std::filesystem::exists(path));
    file.commit();
    EXPECT_EQ(read_text_file(path), whole);
    EXPECT_EQ(entries(folder.path()), 1U);
}

TEST(AtomicFile, WithoutACommitLeavesNoTrace) {
    const TemporaryFolder folder;
    { AtomicFile(folder.path() / "x").write(std::string(200000, 'n')); }
    EXPECT_EQ(entries(folder.path()), 0U);
}

TEST(AtomicFile, RefusesAPipeThatNobodyReads) {
    const TemporaryFolder folder;
    const auto pipe = folder.path() / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THAT(complaint_of([&] { AtomicFile file(pipe); }), testing::HasSubstr("that no program reads"));
    const int reader = ::open(pipe.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    write_file_atomically(pipe, "content");
    char content[8] = {};
    EXPECT_EQ(::read(reader, content, sizeof content), 7);
    ::close(reader);
}

TEST(AtomicFile, WritesToAPipeThatOnlyALinkOfTheKernelNames) {
    std::array<int, 2> ends{};
    ASSERT_EQ(::pipe2(ends.data(), O_CLOEXEC), 0);
    write_file_atomically("/proc/self/fd/" + std::to_string(ends[1]), "content");
    std::array<char, 8> content{};
    EXPECT_EQ(::read(ends[0], content.data(), content.size()), 7);
    for (const int end : ends) ::close(end);
}

TEST(File, ThatIsAPipeWaitsForASlowWriter) {
    const TemporaryFolder folder;
    const auto pipe = folder.path() / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    const int writer = ::open(pipe.c_str(), O_RDWR | O_CLOEXEC);
    auto content = std::async(std::launch::async, [&] { return read_text_file(pipe); });
    EXPECT_EQ(content.wait_for(std::chrono::milliseconds(20)), std::future_status::timeout);
    EXPECT_EQ(::write(writer, "late", 4), 4);
    ::close(writer);
    EXPECT_EQ(content.get(), "late");
}

}  // namespace THIS_TEST
}  // namespace fretwork::base

// SPDX-License-Identifier: GPL-3.0-or-later
// A writer may be killed, and the disk may fill up, at any moment.
#include "process.hpp"
#include "sample.hpp"

#include <sqlite3.h>

namespace fretwork::library {
namespace THIS_TEST {

using namespace test;

std::vector<PatternData> whole_batch() {
    std::vector<PatternData> batch;
    for (const char* id : {"0-1+1-6", "1-6+3-6", "0-1+1-5+3-6+5-6"})
        batch.push_back(sample_data(id, static_cast<double>(batch.size()) + 1.0));
    return batch;
}

/// The content of the library after an uninterrupted run.
std::string undisturbed_hash() {
    const TemporaryFolder folder;
    Library library = make_library(folder.path() / "lib.db");
    library.store(whole_batch());
    return library.content_hash();
}

void expect_whole(const std::filesystem::path& path) {
    sqlite3* handle = nullptr;
    ASSERT_EQ(sqlite3_open(path.c_str(), &handle), SQLITE_OK);
    std::string verdict;
    const auto keep_row = [](void* target, int, char** values, char**) {
        *static_cast<std::string*>(target) += values[0];
        return 0;
    };
    sqlite3_exec(handle, "PRAGMA integrity_check", keep_row, &verdict, nullptr);
    sqlite3_close(handle);
    EXPECT_EQ(verdict, "ok");
}

TEST(LibraryCrash, AKillDuringABatchLosesThatBatchOnly) {
    const std::string wanted = undisturbed_hash();
    for (const rlim_t room : {0U, 4096U, 16384U, 65536U}) {
        const TemporaryFolder folder;
        const auto path = folder.path() / "lib.db";
        const std::string before = make_library(path).content_hash();
        const rlim_t size = std::filesystem::file_size(path);
        const int status = status_of([&] {
            limit_files(size + room, [](int) { ::kill(::getpid(), SIGKILL); });
            Library::open(path, Access::ReadWrite).store(whole_batch());
        });
        ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) << room;
        ASSERT_TRUE(std::filesystem::exists(path.string() + "-journal"))
            << "killed too early to mean something";
        EXPECT_EQ(Library::open(path).content_hash(), before) << room;
        expect_whole(path);
        Library::open(path, Access::ReadWrite).store(whole_batch());
        EXPECT_EQ(Library::open(path).content_hash(), wanted) << room;
    }
}

TEST(LibraryCrash, SurvivesKillDuringWrite) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "lib.db";
    make_library(path);
    const auto left_to_write = [&](const Library& library) {
        std::vector<PatternData> left;
        for (const PatternData& data : whole_batch()) {
            for (const pattern::NamedPattern& open : library.patterns_without_responses())
                if (open.id == data.pattern) left.push_back(data);
        }
        return left;
    };
    const auto prepare = [&] {
        const auto library = std::make_shared<Library>(Library::open(path, Access::ReadWrite));
        return [library, left = left_to_write(*library)] {
            if (!left.empty()) library->store(std::vector{left.front()});
        };
    };
    // Each process stores one pattern at most; where in that the kill falls is up to the machine.
    for (const useconds_t delay : {0U, 1000U, 3000U, 9000U, 27000U}) {
        const std::size_t before = left_to_write(Library::open(path)).size();
        kill_within(delay, prepare);
        expect_whole(path);
        EXPECT_LE(before - left_to_write(Library::open(path)).size(), 1U);
    }
    Library library = Library::open(path, Access::ReadWrite);
    const auto left = left_to_write(library);
    if (!left.empty()) library.store(left);
    EXPECT_EQ(library.content_hash(), undisturbed_hash());
}

TEST(LibraryCrash, AFullDiskIsAnErrorAndLeavesTheFileAsItWas) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "lib.db";
    const std::string before = make_library(path).content_hash();
    const rlim_t size = std::filesystem::file_size(path);
    const int status = status_of([&] {
        limit_files(size + 20000, SIG_IGN);
        Library library = Library::open(path, Access::ReadWrite);
        try {
            library.store(whole_batch());
        } catch (const base::IoError&) {
            ::_exit(library.content_hash() == before ? 3 : 4);
        }
    });
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 3);
    EXPECT_EQ(Library::open(path).content_hash(), before);
    expect_whole(path);
}

TEST(LibraryCrash, CreatingOnAFullDiskLeavesNothing) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "lib.db";
    const int status = status_of([&] {
        limit_files(8192, SIG_IGN);
        try {
            make_library(path);
        } catch (const base::IoError&) {
            ::_exit(3);
        }
    });
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 3);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(LibraryCrash, ALibraryCanBeCreatedAfterAKillDuringCreation) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "lib.db";
    const int status = status_of([&] {
        limit_files(8192, [](int) { ::kill(::getpid(), SIGKILL); });
        make_library(path);
    });
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(Library::open_or_create(path, paper_layout(), reduction::paper_setting()).pattern_count(), 0U);
}

}  // namespace THIS_TEST
}  // namespace fretwork::library

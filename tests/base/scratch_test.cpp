// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"

#include <fretwork/base/files/scratch.hpp>

#include <csignal>
#include <cstdlib>
#include <optional>
#include <string>
#include <sys/wait.h>

namespace fretwork::base {
namespace THIS_TEST {

using test::TemporaryFolder;

std::size_t entries(const std::filesystem::path& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

/// A variable of the environment that is set, or with a null pointer unset, until the end of a scope.
class Variable {
  public:
    Variable(const char* name, const char* value) : name_(name) {
        if (const char* before = std::getenv(name); before != nullptr) before_ = before;
        set(value);
    }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;
    ~Variable() { set(before_ ? before_->c_str() : nullptr); }

  private:
    void set(const char* value) const {
        if (value != nullptr) {
            ::setenv(name_, value, 1);
        } else {
            ::unsetenv(name_);
        }
    }
    const char* name_;
    std::optional<std::string> before_;
};

class OfBothKinds : public testing::TestWithParam<Scratch::Kind> {};
INSTANTIATE_TEST_SUITE_P(Scratch, OfBothKinds, testing::Values(Scratch::Kind::File, Scratch::Kind::Folder));

TEST_P(OfBothKinds, VanishesUnlessItWasMoved) {
    const TemporaryFolder folder;
    const auto target = folder.path() / "x";
    { const Scratch scratch(target, GetParam()); }
    EXPECT_EQ(entries(folder.path()), 0U);
    {
        Scratch scratch(target, GetParam());
        std::filesystem::rename(scratch.path(), target);
        scratch.release();
    }
    EXPECT_TRUE(std::filesystem::exists(target));
}

TEST_P(OfBothKinds, OfALivingProcessIsLeftAlone) {
    const TemporaryFolder folder;
    const Scratch first(folder.path() / "x", GetParam());
    const Scratch second(folder.path() / "x", GetParam());
    EXPECT_NE(first.path(), second.path());
    EXPECT_EQ(entries(folder.path()), 2U);
}

TEST_P(OfBothKinds, OfAKilledProcessIsRemovedByTheNext) {
    const TemporaryFolder folder;
    const pid_t child = ::fork();
    if (child == 0) {
        const Scratch left(folder.path() / "x", GetParam());
        if (GetParam() == Scratch::Kind::Folder) write_file_atomically(left.path() / "inner", "text");
        ::raise(SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    ASSERT_EQ(entries(folder.path()), 1U) << "the killed process must have left something";
    const Scratch next(folder.path() / "other", GetParam());
    EXPECT_EQ(entries(folder.path()), 1U);
    EXPECT_TRUE(std::filesystem::exists(next.path()));
}

TEST(Scratch, NamesTheTargetWhereItCannotBeMade) {
    EXPECT_THAT(test::complaint_of([] { Scratch("nowhere/x", Scratch::Kind::File); }),
                testing::StartsWith("nowhere/x: cannot be written: "));
}

TEST(Scratch, LeavesFilesOfOthersAlone) {
    const TemporaryFolder folder;
    (void)folder.file(".fretwork-notes.txt", "mine");
    (void)folder.file("fretwork-123456", "mine");
    const Scratch scratch(folder.path() / "x", Scratch::Kind::File);
    EXPECT_EQ(entries(folder.path()), 3U);
}

TEST(Scratch, AMissingTemporaryFolderIsNamedWithTheVariableThatIsUsed) {
    const Variable first("TMPDIR", nullptr);
    const Variable third("TEMP", "/nowhere/third");
    EXPECT_THAT(test::complaint_of([] {
                    const Variable second("TMP", "/nowhere/second");
                    (void)temporary_folder();
                }),
                testing::HasSubstr(", TMP, is '/nowhere/second': "));
    const Variable second("TMP", nullptr);
    EXPECT_THAT(test::complaint_of([] { (void)temporary_folder(); }),
                testing::HasSubstr(", TEMP, is '/nowhere/third': "));
}

}  // namespace THIS_TEST
}  // namespace fretwork::base

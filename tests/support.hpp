// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by the tests of every stage.
#pragma once

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <unistd.h>

namespace fretwork::test {

/// A folder of this test's own that vanishes with it.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "fretwork-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw base::IoError("no temporary folder can be made");
        path_ = name;
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// A file of this folder, written.
    std::filesystem::path file(std::string_view name, std::string_view content) const {
        base::write_file_atomically(path_ / name, content);
        return path_ / name;
    }

  private:
    std::filesystem::path path_;
};

/// The one line with which `action` refuses its input; a failed test if it does not.
template <class Action>
std::string complaint_of(Action&& action) {
    try {
        action();
    } catch (const base::Error& error) {
        std::string message = error.what();
        EXPECT_EQ(message.find('\n'), std::string::npos) << "a complaint is one line: " << message;
        return message;
    }
    ADD_FAILURE() << "nothing was refused";
    return "";
}

}  // namespace fretwork::test

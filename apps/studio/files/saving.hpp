// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/files/file_lock.hpp>
#include <fretwork/base/internal/json_text.hpp>

#include <filesystem>
#include <string>

namespace fretwork::studio {

/// Check that a file of a kind, such as "project", may be saved there: its name ends in .json, and it does
/// not exist or is of that kind. Throws InputError, so that no other file is lost.
void require_file_of_kind(const std::filesystem::path& path, const std::string& kind);

/// A file that is replaced only after people have confirmed it.
struct Conflict {
    enum class Reason {
        Changed,  ///< another program has written it since it was read
        Exists    ///< another file is there
    };
    std::filesystem::path path;
    Reason reason;
    std::string hash{};  ///< of the file that is there
    std::string kind;    ///< "project", ..
    /// Why it is not replaced, in one line.
    [[nodiscard]] std::string text() const;
    /// The key `conflict` of the refusal.
    [[nodiscard]] base::Json json() const;
};

/// Take the lock that the commands take, too: on the file if it exists, else on its folder. Throws InputError
/// if another program has this lock.
base::FileLock lock_for_writing(const std::filesystem::path& path);

}  // namespace fretwork::studio

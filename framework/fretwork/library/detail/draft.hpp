// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/files/scratch.hpp>

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <string>
#include <system_error>
#include <unistd.h>

namespace fretwork::library::detail {

/// A new library with its journal, in a scratch folder beside the output. The draft is deleted unless it is
/// moved into place. Several processes may make the same output at once: each has its own draft, and the
/// first to finish makes the output.
class Draft {
  public:
    /// Throws IoError that names the output.
    explicit Draft(const std::filesystem::path& output)
        : output_(output),
          target_(base::link_target(output)),
          scratch_(target_, base::Scratch::Kind::Folder),
          path_(scratch_.path() / target_.filename()) {}
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    /// Run an action that fills the draft. Errors about the draft name the output instead, because users do
    /// not know the draft.
    template <class Action>
    void fill(Action&& action) const {
        try {
            action();
        } catch (const base::InputError& error) {
            throw base::renamed(error, path_.string(), output_.string());
        } catch (const base::IoError& error) {
            throw base::renamed(error, path_.string(), output_.string());
        }
    }

    /// Move the draft to the output's place. False, without a change, if the output exists by now. Throws
    /// IoError.
    [[nodiscard]] bool move_into_place() const {
        if (::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target_.c_str(), RENAME_NOREPLACE) == 0)
            return true;
        // Some network disks do not support this renaming, but support links, which never replace a file
        // either.
        if (errno == EINVAL || errno == ENOSYS) {
            if (::link(path_.c_str(), target_.c_str()) == 0) return true;
        }
        if (errno == EEXIST) return false;
        throw base::IoError(
            output_.string(), "",
            "cannot be written: " + std::error_code(errno, std::generic_category()).message());
    }

  private:
    std::filesystem::path output_;
    std::filesystem::path target_;  ///< the file to which the output's links lead
    base::Scratch scratch_;
    std::filesystem::path path_;
};

}  // namespace fretwork::library::detail

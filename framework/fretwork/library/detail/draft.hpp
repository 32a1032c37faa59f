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

/// A library in a scratch folder beside the output, with its journal; it vanishes unless it is moved into its
/// place. Several processes may make the same output at once: each has its own draft, and only the first to
/// finish gives the output.
class Draft {
  public:
    /// Throws IoError that names the output.
    explicit Draft(const std::filesystem::path& output)
        : output_(output),
          target_(base::link_target(output)),
          scratch_(target_, base::Scratch::Kind::Folder),
          path_(scratch_.path() / target_.filename()) {}
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    /// Run what fills the draft: its complaints about the draft name the output, which people know.
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

    /// False, and nothing is touched, if the output has appeared meanwhile. Throws IoError.
    [[nodiscard]] bool move_into_place() const {
        if (::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target_.c_str(), RENAME_NOREPLACE) == 0)
            return true;
        // Some network disks cannot rename so, but link: a link never replaces, either.
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
    std::filesystem::path target_;  ///< where the output's links lead
    base::Scratch scratch_;
    std::filesystem::path path_;
};

}  // namespace fretwork::library::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/error.hpp>

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <random>
#include <string>
#include <system_error>
#include <unistd.h>

namespace fretwork::library::detail {

/// A temporary file beside the output, removed unless it is moved into its place. Several processes may make
/// the same output at once: each has a draft of its own, and only the first to finish gives the output.
class Draft {
  public:
    explicit Draft(const std::filesystem::path& output)
        : output_(output), path_(output.string() + ".making-" + own_suffix()) {
        remove();
    }
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;
    ~Draft() { remove(); }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// False, and nothing is touched, if the output has appeared meanwhile. Throws IoError.
    [[nodiscard]] bool move_into_place() const {
        if (::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, output_.c_str(), RENAME_NOREPLACE) == 0)
            return true;
        // Some network disks cannot rename so, but link: a link never replaces, either.
        if (errno == EINVAL || errno == ENOSYS) {
            if (::link(path_.c_str(), output_.c_str()) == 0) return true;
        }
        if (errno == EEXIST) return false;
        throw base::IoError(output_.string() + ": cannot be written: " +
                            std::error_code(errno, std::generic_category()).message());
    }

  private:
    /// Processes of several machines may share the folder, so their numbers alone would not do.
    static std::string own_suffix() {
        std::random_device random;
        return std::to_string(::getpid()) + "-" + std::to_string(random());
    }
    void remove() const {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
        std::filesystem::remove(path_.string() + "-journal", ignored);
    }
    std::filesystem::path output_;
    std::filesystem::path path_;
};

}  // namespace fretwork::library::detail

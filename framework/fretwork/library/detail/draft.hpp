// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/error.hpp>

#include <filesystem>
#include <string>
#include <unistd.h>

namespace fretwork::library::detail {

/// A library beside the output that vanishes unless it is moved into its place. Several processes may make
/// the same output at once: each has a draft of its own, and only the first to finish gives the output.
class Draft {
  public:
    explicit Draft(const std::filesystem::path& output)
        : output_(output), path_(output.string() + ".making-" + std::to_string(::getpid())) {
        remove();
    }
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;
    ~Draft() { remove(); }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// Throws IoError, also if the output has appeared meanwhile: unlike a renaming, a link never replaces.
    void move_into_place() const {
        std::error_code error;
        std::filesystem::create_hard_link(path_, output_, error);
        if (error) throw base::IoError(output_.string() + ": cannot be written: " + error.message());
    }

  private:
    void remove() const {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
        std::filesystem::remove(path_.string() + "-journal", ignored);
    }
    std::filesystem::path output_;
    std::filesystem::path path_;
};

}  // namespace fretwork::library::detail

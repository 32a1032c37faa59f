// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/error.hpp>

#include <filesystem>

namespace fretwork::library::detail {

/// A library beside the output that vanishes unless it is renamed into its place.
class Draft {
  public:
    explicit Draft(const std::filesystem::path& output)
        : output_(output), path_(output.string() + ".making") {
        remove();
    }
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;
    ~Draft() { remove(); }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    void move_into_place() const {
        std::error_code error;
        std::filesystem::rename(path_, output_, error);
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

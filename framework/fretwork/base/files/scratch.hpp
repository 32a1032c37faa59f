// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <utility>

namespace fretwork::base {

/// A file or folder for content that is not whole yet, in the folder where the content is to be. It vanishes
/// with this object unless it was moved into its place.
///
/// The next scratch in a folder removes the leftovers of killed processes: a living process holds a lock on
/// its scratch. The names begin with ".fretwork-".
class Scratch {
  public:
    enum class Kind { File, Folder };
    /// @param target  what is to be made; its folder must be there
    /// Throws IoError that names the target.
    Scratch(const std::filesystem::path& target, Kind kind);
    Scratch(Scratch&& other) noexcept
        : path_(std::exchange(other.path_, {})), descriptor_(std::exchange(other.descriptor_, -1)) {}
    Scratch& operator=(Scratch&&) = delete;
    ~Scratch();

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// Open for reading and writing if it is a file.
    [[nodiscard]] int descriptor() const { return descriptor_; }
    /// It has been renamed: there is nothing to remove any more.
    void release() { path_.clear(); }

  private:
    std::filesystem::path path_;
    int descriptor_ = -1;
};

}  // namespace fretwork::base

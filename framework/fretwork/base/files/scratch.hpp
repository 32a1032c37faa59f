// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <utility>

namespace fretwork::base {

/// A temporary file or folder for unfinished content, in the folder of its target. The destructor removes it
/// unless it was renamed to the target.
///
/// A running process holds a lock on its scratch. The next scratch in the same folder removes the scratches
/// without a lock, which killed processes have left. The name of a scratch begins with ".fretwork-".
class Scratch {
  public:
    /// The choice between a temporary file and a temporary folder.
    enum class Kind { File, Folder };
    /// @param target  the file or folder to be made; its parent folder must exist
    ///
    /// Throws IoError that names the target.
    Scratch(const std::filesystem::path& target, Kind kind);
    Scratch(Scratch&& other) noexcept
        : path_(std::exchange(other.path_, {})), descriptor_(std::exchange(other.descriptor_, -1)) {}
    Scratch& operator=(Scratch&&) = delete;
    ~Scratch();

    /// The path of the scratch.
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// The descriptor that holds the lock. The descriptor of a file is open for reading and writing.
    [[nodiscard]] int descriptor() const { return descriptor_; }
    /// Keep the content, which has been renamed: the destructor then removes nothing.
    void release() { path_.clear(); }

  private:
    std::filesystem::path path_;
    int descriptor_ = -1;
};

/// The folder for temporary files: the value of the first of the variables TMPDIR, TMP, TEMP and TEMPDIR that
/// is set, or /tmp. Throws IoError that names the variable and the folder if it is no folder.
std::filesystem::path temporary_folder();

}  // namespace fretwork::base

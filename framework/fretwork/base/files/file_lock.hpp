// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

namespace fretwork::base {

/// Keeps others from changing a file while this process reads it, changes it and writes it back.
///
/// The lock is the operating system's (`flock`) on the file itself: it ends with the process, however that
/// ends, and leaves nothing in the folder. It protects against those who take it, too. Writing the file
/// atomically puts a new one in its place, so a lock covers one change; who writes again and again, or makes
/// the file, locks its folder.
class FileLock {
  public:
    /// Lock a file or a folder; waits while another holds it. Throws InputError if there is none, IoError if
    /// it cannot be locked.
    explicit FileLock(const std::filesystem::path& path);
    /// The same without waiting: nothing if another holds it.
    static std::optional<FileLock> try_lock(const std::filesystem::path& path);

    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&& other) noexcept;
    ~FileLock();

  private:
    explicit FileLock(int descriptor) : descriptor_(descriptor) {}
    int descriptor_ = -1;
};

}  // namespace fretwork::base

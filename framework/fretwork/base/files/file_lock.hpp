// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

namespace fretwork::base {

/// A lock that keeps other processes from changing a file while this process reads it, changes it and writes
/// it back.
///
/// The operating system holds the lock (`flock`) on the file itself. The lock ends with the process, also
/// with a killed one, and leaves nothing in the folder. The lock protects only against processes that lock
/// the file, too. An atomic write replaces the locked file by a new one, so one lock covers one change. To
/// write repeatedly, or to create the file, lock its folder.
class FileLock {
  public:
    /// Lock a file or a folder, and wait while another process or another FileLock holds the lock. Throws
    /// InputError if the path cannot be opened, IoError if it cannot be locked.
    explicit FileLock(const std::filesystem::path& path);
    /// Lock without waiting. Returns nothing if another holds the lock. Throws as the constructor.
    static std::optional<FileLock> try_lock(const std::filesystem::path& path);

    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&& other) noexcept;
    ~FileLock();

  private:
    explicit FileLock(int descriptor) : descriptor_(descriptor) {}
    int descriptor_ = -1;
};

}  // namespace fretwork::base

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::base {

/// Read a whole file. Throws InputError if it is missing, a folder, or unreadable.
std::string read_text_file(const std::filesystem::path& path);

/// The file that is read or written under this name: where a chain of symbolic links ends, which may be a
/// file that is not there yet.
std::filesystem::path link_target(std::filesystem::path path);

/// Put `content` in the place of `path`, all of it or nothing: a temporary file beside it is written, flushed
/// to the disk and renamed. Throws IoError (folder missing, no permission, disk full), and then `path` is as
/// it was.
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

/// The same for content that comes piece by piece and may be large. What is never committed leaves no trace;
/// devices and pipes (/dev/stdout) are written at once.
class AtomicFile {
  public:
    /// Throws IoError.
    explicit AtomicFile(std::filesystem::path path);
    AtomicFile(AtomicFile&&) noexcept;
    AtomicFile& operator=(AtomicFile&&) noexcept;
    ~AtomicFile();

    /// Append. Throws IoError.
    void write(std::string_view content);
    /// Send all that was written to the disk, so that only the place is missing. Throws IoError.
    void flush();
    /// Put all that was written in the place of the path. Throws IoError, and then the path is as it was.
    void commit();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Files that belong together: all of them are written, or none (but for a failure between two renamings).
class FileBatch {
  public:
    /// Throws IoError.
    void add(const std::filesystem::path& path, std::string_view content);
    /// Throws IoError.
    void commit();

  private:
    std::vector<AtomicFile> files_;
};

}  // namespace fretwork::base

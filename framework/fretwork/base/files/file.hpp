// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::base {

/// Read a whole file. Throws InputError if it is missing, a folder, a device, unreadable, or longer than 4
/// GiB.
std::string read_text_file(const std::filesystem::path& path);

/// The file that is read or written under this name: where a chain of symbolic links ends, which may be a
/// file that is not there yet.
std::filesystem::path link_target(std::filesystem::path path);

/// Put `content` in the place of `path`, all of it or nothing: a scratch file beside it is written, flushed
/// to the disk and renamed. A symbolic link stays, and the file that it leads to is replaced. Throws IoError
/// (folder missing, no permission, disk full), and then `path` is as it was.
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

/// The same for content that comes piece by piece and may be large. Content that is never committed leaves no
/// trace; devices and pipes (/dev/stdout) are written at once.
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

/// Many files of one folder, which is made if it is not there: they appear in it when they are committed, and
/// wait for the disk once. If a file cannot be written, the folder is as it was.
class FolderBatch {
  public:
    /// Throws IoError.
    explicit FolderBatch(std::filesystem::path folder);
    FolderBatch(FolderBatch&&) noexcept;
    FolderBatch& operator=(FolderBatch&&) noexcept;
    ~FolderBatch();

    /// Where the files are until they are committed; others than those that are added may be written here.
    [[nodiscard]] const std::filesystem::path& path() const;
    /// Throws IoError.
    void add(const std::string& name, std::string_view content);
    /// Throws IoError.
    void commit();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fretwork::base

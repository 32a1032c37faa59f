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

/// The file at the end of a chain of symbolic links that starts at `path`: reading or writing `path` reads or
/// writes this file. The file need not exist yet.
std::filesystem::path link_target(std::filesystem::path path);

/// Replace the file at `path` by `content`, whole or not at all: a scratch file beside it is written, flushed
/// to the disk and renamed. A symbolic link stays, and its target is replaced. Throws IoError (folder
/// missing, no permission, disk full) and leaves `path` as it was.
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

/// An atomic write of content that comes piece by piece and may be large. Content that is never committed
/// leaves no trace. Content for a device or a pipe (/dev/stdout) is written to it directly.
class AtomicFile {
  public:
    /// Create the scratch file. Throws IoError.
    explicit AtomicFile(std::filesystem::path path);
    AtomicFile(AtomicFile&&) noexcept;
    AtomicFile& operator=(AtomicFile&&) noexcept;
    ~AtomicFile();

    /// Append content. Throws IoError.
    void write(std::string_view content);
    /// Flush everything written so far to the disk, so that `commit` only has to rename the file. Throws
    /// IoError.
    void flush();
    /// Replace the file at the path by everything written so far. Throws IoError and leaves the file at the
    /// path as it was.
    void commit();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Files that belong together: all of them are written, or none. Only a failure between two renamings can
/// leave some of them.
class FileBatch {
  public:
    /// Write content to the scratch file of one more file. Throws IoError.
    void add(const std::filesystem::path& path, std::string_view content);
    /// Put all files in their places. Throws IoError.
    void commit();

  private:
    std::vector<AtomicFile> files_;
};

/// A batch of files for one folder, which is created if it is missing. The files appear in the folder when
/// the batch is committed, with one flush to the disk. If a file cannot be written, the folder stays as it
/// was.
class FolderBatch {
  public:
    /// Create the scratch folder. Throws IoError.
    explicit FolderBatch(std::filesystem::path folder);
    FolderBatch(FolderBatch&&) noexcept;
    FolderBatch& operator=(FolderBatch&&) noexcept;
    ~FolderBatch();

    /// The folder of the files until they are committed. The caller may also write files into it directly.
    [[nodiscard]] const std::filesystem::path& path() const;
    /// Write a file of the batch. Throws IoError.
    void add(const std::string& name, std::string_view content);
    /// Put all files into the folder. Throws IoError.
    void commit();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fretwork::base

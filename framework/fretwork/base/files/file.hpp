// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::base {

/// Read a whole file. Throws InputError if it is missing, a folder, a device other than a terminal,
/// unreadable, larger than the memory, or a pipe with more than 1 GiB.
std::string read_text_file(const std::filesystem::path& path);

/// The ending of a file's name with its dot, in small letters: ".svg" for "Chair.SVG"; "" if it has none.
std::string ending_of(const std::filesystem::path& path);

/// Follow a chain of symbolic links from `path` to its end. The file at the end need not exist yet.
std::filesystem::path link_target(std::filesystem::path path);

/// Refuse to replace a file that nobody may write (mode 444): its owner has protected it, also against a
/// program that may replace every file of its folder. Throws IoError. A file that is missing passes.
void check_protection(const std::filesystem::path& path);

/// Replace the file at `path` by `content`, whole or not at all. A scratch file beside it is written, flushed
/// to the disk and renamed. A symbolic link stays, and its target is replaced. A device or a pipe is written
/// directly. Throws IoError (folder missing, no permission, protected file, disk full); a file at `path` then
/// stays as it was.
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

/// An atomic write of content in pieces. Content that is not committed leaves no trace. A device or a pipe
/// (/dev/stdout, unless it is redirected to a file) is written directly.
class AtomicFile {
  public:
    /// Create the scratch file. Throws IoError.
    explicit AtomicFile(std::filesystem::path path);
    AtomicFile(AtomicFile&&) noexcept;
    AtomicFile& operator=(AtomicFile&&) noexcept;
    ~AtomicFile();

    /// Append content. Throws IoError.
    void write(std::string_view content);
    /// Flush the content to the disk, so that only the renaming is left for `commit`. Throws IoError.
    void flush();
    /// Replace the file at the path by the content. Throws IoError; the file then stays as it was.
    void commit();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Files that are replaced together, all or none. Only a failure between two renamings can leave some
/// of them replaced.
class FileBatch {
  public:
    /// Write content to the scratch file of one more file. Throws IoError.
    void add(const std::filesystem::path& path, std::string_view content);
    /// Replace all files. Throws IoError.
    void commit();

  private:
    std::vector<AtomicFile> files_;
};

/// A batch of files for one folder, which is created if it is missing. The files appear in the folder when
/// the batch is committed, with one flush to the disk. Before that, the folder stays as it was, apart from
/// the hidden scratch folder. Only a failure between two renamings can leave a part of the files in it.
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
    /// Move all files into the folder. Throws IoError.
    void commit();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fretwork::base

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

namespace fretwork::base::detail {

/// Owns an open descriptor.
class OpenFile {
  public:
    explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile() { ::close(descriptor_); }

  private:
    int descriptor_;
};

/// The meaning of a path that is a symbolic link: the file that it leads to, or the link itself.
enum class Links { Followed, Themselves };

/// False if another file has taken the place of the one that was opened.
inline bool is_still_at(const std::filesystem::path& path, int descriptor, Links links) {
    struct stat opened {};
    struct stat present {};
    const auto look = links == Links::Followed ? ::stat : ::lstat;
    return ::fstat(descriptor, &opened) == 0 && look(path.c_str(), &present) == 0 &&
           opened.st_dev == present.st_dev && opened.st_ino == present.st_ino;
}

}  // namespace fretwork::base::detail

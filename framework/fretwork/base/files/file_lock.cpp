// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/detail/open_file.hpp>
#include <fretwork/base/files/file_lock.hpp>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

namespace fretwork::base {
namespace {

enum class Wait { No, Yes };

/// Open for writing if possible, because network disks lock only such files. Folders and read-only files are
/// opened for reading.
int open_for_lock(const std::filesystem::path& path) {
    const int writable = ::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK);
    const int descriptor = writable >= 0 ? writable : ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0)
        throw InputError(path.string(), "", std::string("cannot be read: ") + std::strerror(errno));
    return descriptor;
}

/// False if another holds the lock. Throws IoError.
bool lock(int descriptor, const std::filesystem::path& path, Wait wait) {
    const int operation = wait == Wait::Yes ? LOCK_EX : LOCK_EX | LOCK_NB;
    while (::flock(descriptor, operation) != 0) {
        if (errno == EWOULDBLOCK) return false;
        if (errno != EINTR)
            throw IoError(path.string(), "",
                          std::string("cannot be locked against other programs: ") + std::strerror(errno));
    }
    return true;
}

/// A locked descriptor of the present file or folder at the path; -1 if another holds the lock.
int locked_descriptor(const std::filesystem::path& path, Wait wait) {
    for (;;) {
        const int descriptor = open_for_lock(path);
        try {
            if (!lock(descriptor, path, wait)) {
                ::close(descriptor);
                return -1;
            }
        } catch (const IoError&) {
            ::close(descriptor);
            throw;
        }
        if (detail::is_still_at(path, descriptor, detail::Links::Followed)) return descriptor;
        ::close(descriptor);
    }
}

}  // namespace

FileLock::FileLock(const std::filesystem::path& path) : descriptor_(locked_descriptor(path, Wait::Yes)) {}

std::optional<FileLock> FileLock::try_lock(const std::filesystem::path& path) {
    const int descriptor = locked_descriptor(path, Wait::No);
    if (descriptor < 0) return std::nullopt;
    return FileLock(descriptor);
}

FileLock::FileLock(FileLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
}

FileLock::~FileLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace fretwork::base

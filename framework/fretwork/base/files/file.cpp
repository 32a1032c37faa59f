// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/detail/open_file.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/text.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace fretwork::base {
namespace {

/// Refuse folders and devices, which may have no end. A terminal is allowed, because a person types there.
void check_readable(const std::filesystem::path& path, int descriptor, const struct stat& status) {
    if (S_ISDIR(status.st_mode)) throw InputError(path.string(), "", "is a folder, where a file is needed");
    if (S_ISBLK(status.st_mode) || (S_ISCHR(status.st_mode) && ::isatty(descriptor) == 0))
        throw InputError(path.string(), "", "is a device, where a file is needed");
}

/// @param expected  the size as the file system tells it; 0 for pipes, which may have no end
std::string read_to_end(int descriptor, const std::filesystem::path& path, std::size_t expected) {
    constexpr std::size_t kMostOfPipe = std::size_t{1} << 30U;
    constexpr std::size_t kPiece = 1U << 16U;
    std::string content;
    if (expected > content.max_size() - kPiece) throw std::bad_alloc();  // resize() would throw length_error
    content.resize(expected + kPiece);
    std::size_t size = 0;
    for (;;) {
        const ssize_t got = ::read(descriptor, content.data() + size, content.size() - size);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0)
            throw InputError(path.string(), "", std::string("cannot be read: ") + std::strerror(errno));
        if (got == 0) break;
        size += got;
        if (size > std::max(2 * expected, kMostOfPipe))
            throw InputError(path.string(), "",
                             "does not end within 1 GiB, which is all that is read of a pipe");
        if (size == content.size()) content.resize(2 * size);
    }
    content.resize(size);
    return content;
}

}  // namespace

std::string ending_of(const std::filesystem::path& path) {
    return in_small_letters(path.extension().string());
}

std::string read_text_file(const std::filesystem::path& path) {
    // With O_NONBLOCK, a named pipe without a writer opens at once, and is empty. Without the flag, reading
    // then waits for a slow writer.
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0)
        throw InputError(path.string(), "", std::string("cannot be read: ") + std::strerror(errno));
    const detail::OpenFile file(descriptor);
    (void)::fcntl(descriptor, F_SETFL, 0);
    struct stat status {};
    if (::fstat(descriptor, &status) != 0)
        throw InputError(path.string(), "", std::string("cannot be read: ") + std::strerror(errno));
    check_readable(path, descriptor, status);
    try {
        return read_to_end(descriptor, path, status.st_size);
    } catch (const std::bad_alloc&) {
        throw InputError(path.string(), "",
                         "is too large for the memory: " + std::to_string(status.st_size) + " bytes");
    }
}

std::filesystem::path link_target(std::filesystem::path path) {
    constexpr int kMostLinks = 40;  // as in the kernel: a longer chain counts as a circle
    std::error_code fault;
    for (int i = 0; i < kMostLinks && std::filesystem::is_symlink(path, fault); ++i) {
        const std::filesystem::path target = std::filesystem::read_symlink(path, fault);
        if (fault) return path;
        std::filesystem::path next = path.parent_path() / target;
        // Links of the kernel, such as /dev/stdout to a pipe, may have a target without a path.
        if (std::filesystem::exists(path, fault) && !std::filesystem::exists(next, fault)) return path;
        path = std::move(next);
    }
    return path;
}

}  // namespace fretwork::base

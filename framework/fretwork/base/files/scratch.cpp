// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/detail/open_file.hpp>
#include <fretwork/base/files/scratch.hpp>
#include <fretwork/base/text.hpp>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <string_view>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace fretwork::base {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kStart = ".fretwork-";
constexpr std::string_view kPlaceholder = "XXXXXX";  // for mkostemp, mkdtemp

bool is_scratch_name(const fs::path& path) {
    const std::string name = path.filename().string();
    return name.starts_with(kStart) && name.size() == kStart.size() + kPlaceholder.size();
}

/// Removes a scratch that nobody has locked.
void remove_if_abandoned(const fs::path& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) return;
    std::error_code ignored;
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0 &&
        detail::is_still_at(path, descriptor, detail::Links::Themselves))
        fs::remove_all(path, ignored);
    ::close(descriptor);
}

void remove_abandoned(const fs::path& folder) {
    std::vector<fs::path> found;
    std::error_code ignored;
    for (fs::directory_iterator entry(folder, ignored), end; entry != end; entry.increment(ignored)) {
        if (is_scratch_name(entry->path())) found.push_back(entry->path());
    }
    for (const fs::path& path : found) remove_if_abandoned(path);
}

/// Make a file or folder, and put its name into `path`. Returns its descriptor, or -1 and sets errno.
int make(std::string& path, Scratch::Kind kind) {
    if (kind == Scratch::Kind::File) return ::mkostemp(path.data(), O_CLOEXEC);
    const std::string pattern = path;
    while (true) {
        path = pattern;
        if (::mkdtemp(path.data()) == nullptr) return -1;
        const int descriptor = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        // Another process may have removed the new folder as abandoned.
        if (descriptor >= 0 || errno != ENOENT) return descriptor;
    }
}

}  // namespace

Scratch::Scratch(const fs::path& target, Kind kind) {
    const fs::path folder = fs::absolute(target).parent_path();
    remove_abandoned(folder);
    do {
        if (descriptor_ >= 0) ::close(descriptor_);
        std::string name = (folder / kStart).string().append(kPlaceholder);
        descriptor_ = make(name, kind);
        if (descriptor_ < 0)
            throw IoError(target.string(), "", std::string("cannot be written: ") + std::strerror(errno));
        path_ = name;
        // Before this lock, another process may have taken the scratch for abandoned. That process holds the
        // lock while it removes the scratch. Without locks in the file system, no process removes a scratch.
        while (::flock(descriptor_, LOCK_EX) != 0 && errno == EINTR) {
        }
    } while (!detail::is_still_at(path_, descriptor_, detail::Links::Themselves));
}

Scratch::~Scratch() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
    if (descriptor_ >= 0) ::close(descriptor_);
}

fs::path temporary_folder() {
    std::error_code error;
    fs::path folder = fs::temp_directory_path(error);
    if (!error) return folder;
    // temp_directory_path() takes the first of these variables that is set.
    for (const char* variable : {"TMPDIR", "TMP", "TEMP", "TEMPDIR"}) {
        if (const char* wanted = std::getenv(variable); wanted != nullptr)
            throw IoError("the folder for temporary files, " + std::string(variable) + ", is '" +
                          printable(wanted) + "': " + error.message());
    }
    throw IoError("the folder for temporary files is '/tmp', because TMPDIR is not set: " + error.message());
}

}  // namespace fretwork::base

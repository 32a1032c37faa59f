// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/detail/open_file.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/files/scratch.hpp>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <mutex>
#include <optional>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace fretwork::base {
namespace {

[[noreturn]] void fail_to_write(const std::filesystem::path& path, int error_number) {
    throw IoError(path.string(), "", std::string("cannot be written: ") + std::strerror(error_number));
}

void write_all(int descriptor, std::string_view content, const std::filesystem::path& target) {
    while (!content.empty()) {
        const ssize_t written = ::write(descriptor, content.data(), content.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail_to_write(target, errno);
        content.remove_prefix(written);
    }
}

bool is_device(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored);
}

/// Opens a device or a pipe, without waiting for a reader of the pipe: the wait could take forever, and
/// signals would not end it.
int open_device(const std::filesystem::path& path) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0 && errno == ENXIO)
        throw IoError(path.string(), "", "cannot be written: it is a pipe that no program reads");
    if (descriptor < 0) fail_to_write(path, errno);
    // Writing waits for room in the pipe.
    (void)::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
    return descriptor;
}

/// Gives a new file the owner and the group of the file that it replaces, or the group alone, as far as the
/// process may: root replaces files of others, too.
/// @param change  sets the owner and the group of the new file; returns 0 if it did
template <class Change>
void take_owner(const std::filesystem::path& replaced, const Change& change) {
    constexpr auto kKept = static_cast<uid_t>(-1);
    struct stat existing {};
    if (::stat(replaced.c_str(), &existing) != 0) return;
    [[maybe_unused]] const bool is_taken =
        change(existing.st_uid, existing.st_gid) == 0 || change(kKept, existing.st_gid) == 0;
}

}  // namespace

/// Writes the content of one file to a scratch file, until the content is whole. Devices and pipes
/// (/dev/stdout) cannot be replaced, and are written directly. A link stays a link: the file that it leads
/// to is replaced.
struct AtomicFile::Impl {
    explicit Impl(std::filesystem::path path) : named(std::move(path)), target(link_target(named)) {
        if (is_device(target)) {
            device = open_device(target);
        } else {
            scratch.emplace(target, Scratch::Kind::File);
        }
        buffer.reserve(kBufferSize);
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() {
        if (device >= 0) ::close(device);
    }

    void flush() {
        write_all(scratch ? scratch->descriptor() : device, buffer, named);
        buffer.clear();
    }

    /// Devices and pipes have no disk to wait for.
    void synchronize() const {
        if (scratch && ::fsync(scratch->descriptor()) != 0) fail_to_write(named, errno);
    }

    void move_into_place() {
        if (!scratch) return close_device();
        take_owner(target,
                   [&](uid_t user, gid_t group) { return ::fchown(scratch->descriptor(), user, group); });
        if (::fchmod(scratch->descriptor(), wanted_mode()) != 0 ||
            ::rename(scratch->path().c_str(), target.c_str()) != 0)
            fail_to_write(named, errno);
        scratch->release();
    }

    void close_device() {
        const int closed = ::close(std::exchange(device, -1));
        if (closed != 0) fail_to_write(named, errno);
    }

    /// The permissions of the replaced file, or else those that the umask allows. Only its owner can open a
    /// scratch file.
    [[nodiscard]] mode_t wanted_mode() const {
        struct stat existing {};
        if (::stat(target.c_str(), &existing) == 0) return existing.st_mode & 0777U;
        // The umask can be read only by setting it: a second thread would read the zero, and leave it.
        static std::mutex one_at_a_time;
        const std::lock_guard lock(one_at_a_time);
        const mode_t mask = ::umask(0);
        ::umask(mask);
        return 0666U & ~mask;
    }

    static constexpr std::size_t kBufferSize = 1U << 16U;
    std::filesystem::path named;   ///< for messages
    std::filesystem::path target;  ///< where `named` leads
    std::optional<Scratch> scratch;
    int device = -1;
    std::string buffer;
};

struct FolderBatch::Impl {
    explicit Impl(std::filesystem::path folder) : target(std::move(folder)) {
        std::error_code ignored;
        std::filesystem::path base = std::filesystem::absolute(target);
        while (base.has_relative_path() && !std::filesystem::is_directory(base, ignored))
            base = base.parent_path();
        scratch.emplace(base / target.filename(), Scratch::Kind::Folder);
    }

    /// Waits for the disk once, for all files together.
    void synchronize() const {
        if (::syncfs(scratch->descriptor()) != 0) fail_to_write(target, errno);
    }

    void move_into_place() {
        std::error_code fault;
        std::filesystem::create_directories(target, fault);
        if (fault) throw IoError(target.string(), "", "cannot be made: " + fault.message());
        for (const auto& entry : std::filesystem::directory_iterator(scratch->path()))
            check_protection(target / entry.path().filename());
        for (const auto& entry : std::filesystem::directory_iterator(scratch->path())) {
            const std::filesystem::path file = target / entry.path().filename();
            take_owner(file,
                       [&](uid_t user, gid_t group) { return ::lchown(entry.path().c_str(), user, group); });
            if (::rename(entry.path().c_str(), file.c_str()) != 0) fail_to_write(file, errno);
        }
    }

    std::filesystem::path target;
    std::optional<Scratch> scratch;
};

void check_protection(const std::filesystem::path& path) {
    constexpr mode_t kAnybodyWrites = 0222U;
    struct stat existing {};
    if (::stat(path.c_str(), &existing) != 0 || (existing.st_mode & kAnybodyWrites) != 0U) return;
    throw IoError(path.string(), "",
                  "is protected: nobody may write it; name another file, or allow writing (chmod u+w)");
}

AtomicFile::AtomicFile(std::filesystem::path path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
        throw IoError(path.string(), "", "is a folder, where a file is to be written");
    }
    check_protection(path);
    impl_ = std::make_unique<Impl>(std::move(path));
}
AtomicFile::AtomicFile(AtomicFile&&) noexcept = default;
AtomicFile& AtomicFile::operator=(AtomicFile&&) noexcept = default;
AtomicFile::~AtomicFile() = default;

void AtomicFile::write(std::string_view content) {
    impl_->buffer += content;
    if (impl_->buffer.size() >= Impl::kBufferSize) impl_->flush();
}

void AtomicFile::flush() {
    impl_->flush();
    impl_->synchronize();
}

void AtomicFile::commit() {
    flush();
    impl_->move_into_place();
}

void FileBatch::add(const std::filesystem::path& path, std::string_view content) {
    files_.emplace_back(path).write(content);
}

void FileBatch::commit() {
    for (AtomicFile& file : files_) file.flush();
    for (AtomicFile& file : files_) file.commit();
    files_.clear();
}

FolderBatch::FolderBatch(std::filesystem::path folder) : impl_(std::make_unique<Impl>(std::move(folder))) {}
FolderBatch::FolderBatch(FolderBatch&&) noexcept = default;
FolderBatch& FolderBatch::operator=(FolderBatch&&) noexcept = default;
FolderBatch::~FolderBatch() = default;

const std::filesystem::path& FolderBatch::path() const {
    return impl_->scratch->path();
}

void FolderBatch::add(const std::string& name, std::string_view content) {
    constexpr mode_t kReadWrite = 0666;  // less the umask
    const std::filesystem::path shown = impl_->target / name;
    const int descriptor =
        ::open((path() / name).c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, kReadWrite);
    if (descriptor < 0) fail_to_write(shown, errno);
    const detail::OpenFile file(descriptor);
    write_all(descriptor, content, shown);
}

void FolderBatch::commit() {
    impl_->synchronize();
    impl_->move_into_place();
}

void write_file_atomically(const std::filesystem::path& path, std::string_view content) {
    AtomicFile file(path);
    file.write(content);
    file.commit();
}

}  // namespace fretwork::base

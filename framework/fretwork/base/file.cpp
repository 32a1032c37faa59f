// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/file.hpp>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace fretwork::base {
namespace {

[[noreturn]] void fail_to_write(const std::filesystem::path& path, int error_number) {
    throw IoError(path.string() + ": cannot be written: " + std::strerror(error_number));
}

/// A file that vanishes again unless it is renamed into place. Devices and pipes (/dev/stdout) cannot be
/// replaced, only written.
class TemporaryFile {
  public:
    explicit TemporaryFile(std::filesystem::path target) : target_(std::move(target)) {
        std::error_code ignored;
        if (std::filesystem::exists(target_, ignored) &&
            !std::filesystem::is_regular_file(target_, ignored)) {
            descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
        } else {
            path_ = target_.string() + ".XXXXXX";
            descriptor_ = ::mkstemp(path_.data());
        }
        if (descriptor_ >= 0) return;
        const int error_number = errno;
        path_.clear();
        fail_to_write(target_, error_number);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
        if (!path_.empty()) ::unlink(path_.c_str());
    }

    void write(std::string_view content) const {
        while (!content.empty()) {
            const ssize_t written = ::write(descriptor_, content.data(), content.size());
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) fail_to_write(target_, errno);
            content.remove_prefix(static_cast<std::size_t>(written));
        }
    }

    /// Devices and pipes have no disk to wait for.
    void synchronize() const {
        if (!path_.empty() && ::fsync(descriptor_) != 0) fail_to_write(target_, errno);
    }

    void move_into_place() {
        if (path_.empty()) return close_device();
        if (::fchmod(descriptor_, wanted_mode()) != 0) fail_to_write(target_, errno);
        const int closed = ::close(descriptor_);
        descriptor_ = -1;
        if (closed != 0 || ::rename(path_.c_str(), target_.c_str()) != 0) fail_to_write(target_, errno);
        path_.clear();
    }

  private:
    void close_device() {
        const int closed = ::close(descriptor_);
        descriptor_ = -1;
        if (closed != 0) fail_to_write(target_, errno);
    }

    /// mkstemp makes files that only their owner may read; a result is as open as the umask allows, or as it
    /// was.
    [[nodiscard]] mode_t wanted_mode() const {
        struct stat existing {};
        if (::stat(target_.c_str(), &existing) == 0) return existing.st_mode & 0777U;
        const mode_t mask = ::umask(0);
        ::umask(mask);
        return 0666U & ~mask;
    }

    std::filesystem::path target_;
    std::string path_;
    int descriptor_ = -1;
};

}  // namespace

std::string read_text_file(const std::filesystem::path& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
        throw InputError(path.string(), "", "is a folder, where a file is needed");
    }
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw InputError(path.string(), "", std::string("cannot be read: ") + std::strerror(errno));
    std::ostringstream content;
    content << stream.rdbuf();
    if (stream.bad()) throw InputError(path.string(), "", "cannot be read to its end");
    return std::move(content).str();
}

std::filesystem::path link_target(std::filesystem::path path) {
    constexpr int kMostLinks = 40;  // as in the kernel: beyond it they are taken to run in a circle
    std::error_code fault;
    for (int i = 0; i < kMostLinks && std::filesystem::is_symlink(path, fault); ++i) {
        const std::filesystem::path target = std::filesystem::read_symlink(path, fault);
        if (fault) return path;
        path = path.parent_path() / target;
    }
    return path;
}

struct AtomicFile::Impl {
    explicit Impl(const std::filesystem::path& target) : file(target) { buffer.reserve(kBufferSize); }
    void flush() {
        file.write(buffer);
        buffer.clear();
    }
    static constexpr std::size_t kBufferSize = 1U << 16U;
    TemporaryFile file;
    std::string buffer;
};

AtomicFile::AtomicFile(std::filesystem::path path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
        throw IoError(path.string() + ": is a folder, where a file is to be written");
    }
    impl_ = std::make_unique<Impl>(path);
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
    impl_->file.synchronize();
}

void AtomicFile::commit() {
    flush();
    impl_->file.move_into_place();
}

void FileBatch::add(const std::filesystem::path& path, std::string_view content) {
    files_.emplace_back(path).write(content);
}

void FileBatch::commit() {
    for (AtomicFile& file : files_) file.flush();
    for (AtomicFile& file : files_) file.commit();
    files_.clear();
}

void write_file_atomically(const std::filesystem::path& path, std::string_view content) {
    AtomicFile file(path);
    file.write(content);
    file.commit();
}

}  // namespace fretwork::base

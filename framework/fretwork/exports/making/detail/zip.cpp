// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/exports/making/detail/zip.hpp>

#include <memory>
#include <zip.h>

namespace fretwork::exports::detail {
namespace {

[[noreturn]] void fail(const std::string& message) {
    throw base::IoError("an archive cannot be made: " + message);
}

struct Discard {
    void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct Release {
    void operator()(zip_source_t* source) const { zip_source_free(source); }
};

void add(zip_t* archive, const ZipEntry& entry) {
    zip_source_t* source = zip_source_buffer(archive, entry.content.data(), entry.content.size(), 0);
    if (source == nullptr) fail(zip_strerror(archive));
    const zip_int64_t index = zip_file_add(archive, entry.name.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (index < 0) {
        zip_source_free(source);
        fail(zip_strerror(archive));
    }
    const auto number = static_cast<zip_uint64_t>(index);
    constexpr zip_uint16_t kMidnight = 0;
    constexpr zip_uint16_t kFirstOfJanuary1980 = (1U << 5U) | 1U;
    zip_file_set_dostime(archive, number, kMidnight, kFirstOfJanuary1980, 0);
    const zip_int32_t method = entry.kind == ZipEntry::Kind::Stored ? ZIP_CM_STORE : ZIP_CM_DEFLATE;
    constexpr zip_uint32_t kFastest = 1;  // a tenth larger than by default, in a third of the time
    if (zip_set_file_compression(archive, number, method, kFastest) != 0) fail(zip_strerror(archive));
}

std::string bytes_of(zip_source_t* source) {
    zip_stat_t stat;
    if (zip_source_stat(source, &stat) != 0 || zip_source_open(source) != 0) fail("it cannot be read back");
    std::string bytes(stat.size, '\0');
    const zip_int64_t count = zip_source_read(source, bytes.data(), bytes.size());
    zip_source_close(source);
    if (count != static_cast<zip_int64_t>(bytes.size())) fail("it cannot be read back");
    return bytes;
}

}  // namespace

std::string zip_archive(const std::vector<ZipEntry>& entries) {
    zip_error_t error;
    zip_error_init(&error);
    const std::unique_ptr<zip_source_t, Release> target(zip_source_buffer_create(nullptr, 0, 0, &error));
    if (!target) fail(zip_error_strerror(&error));
    std::unique_ptr<zip_t, Discard> archive(zip_open_from_source(target.get(), ZIP_TRUNCATE, &error));
    if (!archive) fail(zip_error_strerror(&error));
    zip_source_keep(target.get());  // the archive frees one reference when it is closed
    for (const ZipEntry& entry : entries) add(archive.get(), entry);
    if (zip_close(archive.get()) != 0) fail(zip_strerror(archive.get()));
    (void)archive.release();
    return bytes_of(target.get());
}

}  // namespace fretwork::exports::detail

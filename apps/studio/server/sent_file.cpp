// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/files/base64.hpp>
#include <fretwork/base/files/file.hpp>
#include <studio/server/sent_file.hpp>
#include <studio/server/sent_name.hpp>

#include <cstdlib>
#include <system_error>

namespace fretwork::studio {

namespace {

/// No kind of file has a longer ending, and with it the name must fit.
constexpr std::size_t kLongestEnding = 32;

std::filesystem::path folder_for_a_while() {
    std::error_code error;
    auto folder = std::filesystem::temp_directory_path(error);
    if (!error) return folder;
    const char* wanted = std::getenv("TMPDIR");
    throw base::IoError("the folder for temporary files, TMPDIR, is '" +
                        shown_name(wanted != nullptr ? wanted : "/tmp") + "': " + error.message());
}

}  // namespace

SentFile parse_sent_file(const base::JsonReader& json) {
    SentFile sent{read_file_name(json.at("name"))};
    sent.content = base::decode_base64(json.at("text_base64").string(), shown_name(sent.name));
    return sent;
}

FileOnDisk::FileOnDisk(const SentFile& sent)
    : shown_(shown_name(sent.name)),
      ending_(std::filesystem::path(sent.name).extension().string().substr(0, kLongestEnding)),
      folder_(folder_for_a_while() / "sent", base::Scratch::Kind::Folder) {
    base::write_file_atomically(path(), sent.content);
}

std::filesystem::path FileOnDisk::path() const {
    return folder_.path() / ("file" + ending_);
}

}  // namespace fretwork::studio

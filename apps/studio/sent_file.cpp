// SPDX-License-Identifier: GPL-3.0-or-later
#include "sent_file.hpp"

#include <fretwork/base/base64.hpp>
#include <fretwork/base/file.hpp>

#include <boost/algorithm/string/replace.hpp>

namespace fretwork::studio {

SentFile parse_sent_file(const base::JsonReader& json) {
    SentFile sent{json.at("name").string()};
    sent.content = base::decode_base64(json.at("text_base64").string(), sent.name);
    return sent;
}

FileOnDisk::FileOnDisk(const SentFile& sent)
    : name_(sent.name),
      folder_(std::filesystem::temp_directory_path() / "sent", base::Scratch::Kind::Folder) {
    base::write_file_atomically(path(), sent.content);
}

std::filesystem::path FileOnDisk::path() const {
    return folder_.path() / ("file" + std::filesystem::path(name_).extension().string());
}

std::string FileOnDisk::renamed(const std::string& message) const {
    return boost::replace_all_copy(message, path().string(), name_);
}

}  // namespace fretwork::studio

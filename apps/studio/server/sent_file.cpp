// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/base64.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/text.hpp>
#include <studio/server/sent_file.hpp>

#include <system_error>

namespace fretwork::studio {
namespace {

namespace fs = std::filesystem;

/// The longest ending that is kept: no kind of file has a longer one, and names have a limit.
constexpr std::size_t kLongestEnding = 32;

std::string shown(const std::string& name) {
    return "'" + shown_name(name) + "'";
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
      folder_(base::temporary_folder() / "sent", base::Scratch::Kind::Folder) {
    base::write_file_atomically(path(), sent.content);
}

std::filesystem::path FileOnDisk::path() const {
    return folder_.path() / ("file" + ending_);
}

std::string shown_name(const std::string& name) {
    constexpr std::size_t kMostShown = 60;
    return base::shortened(base::printable(name), kMostShown);
}

std::string read_plain_text(const base::JsonReader& json) {
    std::string text = json.string();
    if (text.find('\0') != std::string::npos)
        json.fail("is " + shown(text) + " with the character NUL, which no name of a file may have");
    return text;
}

std::string read_name_or_path(const base::JsonReader& json) {
    constexpr std::size_t kMostBytes = 4095;
    std::string text = read_plain_text(json);
    if (text.size() > kMostBytes)
        json.fail("is " + shown(text) + " and has " + std::to_string(text.size()) +
                  " bytes, where a path has at most 4095");
    return text;
}

fs::path read_path(const base::JsonReader& json) {
    const std::string text = read_plain_text(json);
    if (text.empty()) json.fail("is empty, where the path of a file is needed");
    fs::path path = fs::absolute(text).lexically_normal();
    std::error_code error;
    // A missing file is no error here, but a name that the system refuses is one.
    if (fs::status(path, error).type() == fs::file_type::none)
        throw base::InputError(shown(text) + " cannot be a file: " + error.message());
    return path;
}

std::string read_file_name(const base::JsonReader& json) {
    constexpr std::size_t kMostBytes = 255;
    std::string name = read_plain_text(json);
    if (name.empty()) json.fail("is empty, where the name of a file is needed");
    if (name.size() > kMostBytes)
        json.fail("is " + shown(name) + " and has " + std::to_string(name.size()) +
                  " bytes, where the name of a file has at most 255");
    return name;
}

}  // namespace fretwork::studio

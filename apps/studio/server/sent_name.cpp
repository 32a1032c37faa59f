// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <studio/server/sent_name.hpp>

#include <system_error>

namespace fretwork::studio {

namespace fs = std::filesystem;

namespace {

std::string shown(const std::string& name) {
    return "'" + shown_name(name) + "'";
}

}  // namespace

std::string shown_name(const std::string& name) {
    constexpr std::size_t kMostShown = 60;
    return base::shortened(base::printable(name), kMostShown);
}

std::string read_plain_text(const base::JsonReader& json) {
    std::string text = json.string();
    if (text.find('\0') != std::string::npos)
        json.fail("is " + shown(text) + " with the character NUL, which is possible in no name of a file");
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
    const fs::path path = fs::absolute(text).lexically_normal();
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "file_identity.hpp"

#include <fretwork/base/files/file.hpp>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <regex>

namespace fretwork::app {
namespace {

namespace fs = std::filesystem;

std::string lower_case(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

std::string upper_case(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::toupper(c); });
    return text;
}

/// The file system says so if a folder answers to another spelling of its name.
bool ignores_case(fs::path folder) {
    std::error_code ignored;
    for (; folder.has_relative_path(); folder = folder.parent_path()) {
        const std::string name = folder.filename().string();
        const std::string other = name == upper_case(name) ? lower_case(name) : upper_case(name);
        if (other != name) return fs::equivalent(folder, folder.parent_path() / other, ignored);
    }
    return false;
}

/// Where a file that does not exist would be made.
fs::path place_of(const fs::path& path) {
    std::error_code ignored;
    return fs::weakly_canonical(fs::absolute(base::link_target(path), ignored), ignored);
}

bool is_same_place(const fs::path& left, const fs::path& right) {
    if (left == right) return true;
    return left.parent_path() == right.parent_path() &&
           lower_case(left.filename().string()) == lower_case(right.filename().string()) &&
           ignores_case(left.parent_path());
}

/// The format that a JSON text names, wherever its key stands.
std::string format_in(std::istream& stream) {
    static const std::regex format(R"re("format"\s*:\s*"fretwork/([a-z-]+)/[0-9]+")re");
    constexpr std::size_t kPiece = 1U << 16U;
    constexpr std::size_t kOverlap = 256;  // the key may lie across two pieces
    std::string text;
    std::string piece(kPiece, '\0');
    while (stream.read(piece.data(), static_cast<std::streamsize>(kPiece)) || stream.gcount() > 0) {
        text.append(piece, 0, static_cast<std::size_t>(stream.gcount()));
        std::smatch match;
        if (text.find("\"fretwork/") != std::string::npos && std::regex_search(text, match, format))
            return match[1];
        text.erase(0, text.size() - std::min(text.size(), kOverlap));
    }
    return "";
}

}  // namespace

bool is_same_file(const fs::path& left, const fs::path& right) {
    std::error_code ignored;
    const bool left_exists = fs::exists(left, ignored);
    if (left_exists != fs::exists(right, ignored)) return false;
    if (left_exists) return fs::equivalent(left, right, ignored);
    return is_same_place(place_of(left), place_of(right));
}

bool is_device(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(path, ignored) && !fs::is_regular_file(path, ignored) &&
           !fs::is_directory(path, ignored);
}

FileContent content_of(const fs::path& path) {
    constexpr std::string_view kDatabase("SQLite format 3\0", 16);
    constexpr std::size_t kFirstLines = 512;
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) return {};
    std::ifstream stream(path, std::ios::binary);
    FileContent content{.start = std::string(kFirstLines, '\0')};
    stream.read(content.start.data(), kFirstLines);
    content.start.resize(static_cast<std::size_t>(stream.gcount()));
    content.is_database = content.start.starts_with(kDatabase);
    stream.clear();
    stream.seekg(0);
    if (!content.is_database && (stream >> std::ws).peek() == '{') content.format = format_in(stream);
    return content;
}

}  // namespace fretwork::app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "file_identity.hpp"
#include "options/file_options.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/mechanics/frame/frame_file.hpp>

#include <algorithm>
#include <fstream>
#include <regex>

namespace fretwork::app {
namespace {

namespace fs = std::filesystem;

/// The starts of the tables that this program makes, by enumerate, optimizers, export, library export and
/// beams.
constexpr std::string_view kTables[] = {"edges,patterns,",    "id,edges,symmetry,", "problem,best_value,",
                                        "problem,optimizer,", "problem,kind,",      "problem,variable,",
                                        "node,x_m,",          "pattern_id,",        "id,layout,edges,",
                                        "name,position,",     "beam,tile,"};

/// Where a file that does not exist would be made.
fs::path place_of(const fs::path& path) {
    std::error_code ignored;
    return fs::weakly_canonical(fs::absolute(base::link_target(path), ignored), ignored);
}

/// The format that a JSON text names, wherever its key stands.
std::string format_in(std::istream& stream) {
    static const std::regex format(R"re("format"\s*:\s*"fretwork/([a-z-]+)/[0-9]+")re");
    constexpr std::size_t kPiece = 1U << 16U;
    constexpr std::size_t kOverlap = 256;  // the key may lie across two pieces
    std::string text;
    std::string piece(kPiece, '\0');
    while (stream.read(piece.data(), kPiece) || stream.gcount() > 0) {
        text.append(piece, 0, stream.gcount());
        std::smatch match;
        if (text.find("\"fretwork/") != std::string::npos && std::regex_search(text, match, format))
            return match[1];
        text.erase(0, text.size() - std::min(text.size(), kOverlap));
    }
    return "";
}

bool is_frame_as_written(const fs::path& path) {
    try {
        return mechanics::frame_text(mechanics::read_frame(path)) == base::read_text_file(path);
    } catch (const base::InputError&) {
        return false;  // no frame at all
    }
}

bool is_list_of_patterns(std::string_view start) {
    const std::string_view line = start.substr(0, start.find('\n'));
    return line.find_first_not_of("0123456789-+") == std::string_view::npos &&
           line.find('-') != std::string_view::npos;
}

}  // namespace

bool is_same_file(const fs::path& left, const fs::path& right) {
    std::error_code ignored;
    const bool left_exists = fs::exists(left, ignored);
    if (left_exists != fs::exists(right, ignored)) return false;
    return left_exists ? fs::equivalent(left, right, ignored) : place_of(left) == place_of(right);
}

bool is_device(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(path, ignored) && !fs::is_regular_file(path, ignored) &&
           !fs::is_directory(path, ignored);
}

std::string content_of(const fs::path& path) {
    constexpr std::string_view kDatabase("SQLite format 3\0", 16);
    constexpr std::size_t kFirstLines = 512;
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) return "";
    std::ifstream stream(path, std::ios::binary);
    std::string start(kFirstLines, '\0');
    stream.read(start.data(), kFirstLines);
    start.resize(stream.gcount());
    if (start.empty()) return "";
    if (start.starts_with(kDatabase)) return std::string(kLibraryContent);
    stream.clear();
    stream.seekg(0);
    std::string format = (stream >> std::ws).peek() == '{' ? format_in(stream) : "";
    if (format == "frame" && !is_frame_as_written(path)) return std::string(kOtherContent);
    if (!format.empty()) return format;
    const auto table =
        std::ranges::find_if(kTables, [&](std::string_view header) { return start.starts_with(header); });
    if (table != std::end(kTables)) return std::string(*table);
    if (says_who_made_it(start)) return std::string(kDrawnContent);
    return std::string(is_list_of_patterns(start) ? kListContent : kOtherContent);
}

bool is_table(std::string_view content) {
    return std::ranges::find(kTables, content) != std::end(kTables);
}

std::string in_words(std::string_view content) {
    if (content == kLibraryContent) return "a pattern library or another database";
    if (content == kOtherContent) return "not a file that fretwork has made";
    if (content == kDrawnContent) return "a drawing, a mesh or a deck";
    if (content == kListContent) return "a list of patterns";
    if (is_table(content)) return "a table of another kind";
    return (content == "outline" ? "an " : "a ") + std::string(content);
}

}  // namespace fretwork::app

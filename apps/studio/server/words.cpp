// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <studio/server/words.hpp>

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

namespace fretwork::studio {
namespace {

struct KeyRow {
    std::string_view key;
    std::string_view words;  ///< with a number behind it where the key is that of a list
};
constexpr KeyRow kKeys[] = {
    {"load_cases", "load case"},
    {"load_case", "load case"},
    {"supports", "support"},
    {"loads", "load"},
    {"prescribed", "given displacement"},
    {"combines", "combination"},
    {"tile_models", "model of single tiles"},
    {"tessellation", "tiles"},
    {"tile_size", "side of the tiles"},
    {"per_area", "load on an area"},
    {"fixed", "held direction"},
    {"outline", "outline"},
    {"width", "width"},
    {"setting", "material and bars"},
    {"material", "material"},
    {"section", "bars"},
    {"gravity", "gravity"},
    {"model", "model"},
    {"name", "name"},
    {"pattern", "pattern"},
    {"patterns", "patterns"},
    {"palette", "palette"},
    {"property", "property"},
    {"range", "range"},
    {"dither", "dither"},
    {"file", "file"},
    {"tiles", "tile"},
};

std::optional<std::string> words_of(std::string_view key) {
    const auto row = std::ranges::find(kKeys, key, &KeyRow::key);
    if (row == std::end(kKeys)) return std::nullopt;
    return std::string(row->words);
}

bool is_number(std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

std::vector<std::string> split(std::string_view pointer) {
    std::vector<std::string> parts;
    for (const char c : pointer.substr(1)) {
        if (parts.empty()) parts.emplace_back();
        if (c == '/')
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

/// "/load_cases/0/supports/1" is "load case 1, support 2": people count from one. Nothing of what is no place
/// in a project or a request, such as the path of a file.
std::optional<std::string> place_in_words(std::string_view pointer) {
    if (!pointer.starts_with('/')) return std::nullopt;
    const auto parts = split(pointer);
    if (parts.empty() || !words_of(parts.front())) return std::nullopt;
    std::string words;
    for (const std::string& part : parts) {
        if (is_number(part)) {
            words += " " + std::to_string(std::stoull(part.substr(0, 18)) + 1);
            continue;
        }
        std::string plain = part;
        std::ranges::replace(plain, '_', ' ');
        words += (words.empty() ? "" : ", ") + words_of(part).value_or(plain);
    }
    return words;
}

/// Errors are "SOURCE: PLACE: what is wrong".
std::string without_pointers(std::string_view error) {
    constexpr std::string_view kMessage = "message: ";
    if (error.starts_with(kMessage)) error.remove_prefix(kMessage.size());
    std::string words;
    while (!error.empty()) {
        const std::size_t end = error.find(": ");
        const std::string_view part = error.substr(0, end);
        if (part != "/") words += place_in_words(part).value_or(std::string(part)) + ": ";
        if (end == std::string_view::npos) break;
        error.remove_prefix(end + 2);
    }
    return words.substr(0, words.size() - std::min<std::size_t>(words.size(), 2));
}

/// What stands between two pieces of a text; nothing if it has not both.
std::optional<std::string> between(const std::string& text, std::string_view before, std::string_view after) {
    const std::size_t begin = text.find(before);
    if (begin == std::string::npos) return std::nullopt;
    const std::size_t from = begin + before.size();
    const std::size_t to = text.find(after, from);
    if (to == std::string::npos) return std::nullopt;
    return text.substr(from, to - from);
}

}  // namespace

std::string in_words(const std::string& error) {
    if (error.find("nothing holds the structure") != std::string::npos)
        return "Nothing holds the surface. Select nodes and hold them.";
    if (const auto where = between(error, "nothing holds the part of the structure with ", ":"))
        return "Nothing holds the part of the surface near " + *where + ". Select nodes of it and hold them.";
    if (const auto where = between(error, "the structure, as held, can move without strain at ", ":"))
        return "The surface is not held firmly: near " + *where +
               " it still moves or turns freely. Hold more nodes, or hold them in more directions.";
    const auto model = between(error, "has no calibration of the tile model ", ":");
    const auto pattern = between(error, "pattern ", " has no calibration");
    if (model && pattern)
        return "The model " + *model + " needs measured patterns, and " + *pattern +
               " is none of them. Choose another model, or a project that was made with a library of "
               "measured "
               "patterns.";
    return without_pointers(error);
}

std::string in_words(const std::filesystem::filesystem_error& error) {
    const std::string file = error.path1().string();
    return (file.empty() ? "" : file + ": ") + error.code().message();
}

std::string one_line(const std::string& text) {
    constexpr std::size_t kLongest = 500;
    return base::shortened(base::printable(text), kLongest);
}

}  // namespace fretwork::studio

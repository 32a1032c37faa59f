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
    std::string_view words;  ///< a number follows if the key names a list
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
    {"goals", "target point"},
    {"target", "target"},
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

/// "/load_cases/0/supports/1" is "load case 1, support 2": people count from one. Nothing if the text is no
/// place in a project or a request, but for example the path of a file.
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

/// The whole error; its places in files and messages become words.
std::string with_plain_places(const base::ErrorData& data) {
    std::string text;
    const auto add = [&](const std::string& part) {
        if (!part.empty() && part != "/") text += place_in_words(part).value_or(part) + ": ";
    };
    for (const auto& [source, place] : data.where) {
        if (source != std::string_view(kMessageSource)) add(source);
        add(place);
    }
    return text + data.problem;
}

}  // namespace

std::string in_words(const base::Error& error) {
    const auto& about = error.data().about;
    switch (error.data().kind) {
        case base::ErrorKind::NothingHeld:
            return "The surface has no supports. Select nodes and add supports.";
        case base::ErrorKind::PartNotHeld:
            return "The part of the surface near " + about.at(0) +
                   " has no supports. Select nodes of it and add supports.";
        case base::ErrorKind::MovesFreely:
            return "The surface is not held firmly: near " + about.at(0) +
                   " it can still move or rotate. Add supports, or fix more directions.";
        case base::ErrorKind::NotCalibrated:
            return "The model " + about.at(1) + " requires calibrated patterns, and " + about.at(0) +
                   " is not one. Choose another model, or a project with a "
                   "library.";
        case base::ErrorKind::Other:
            break;
    }
    return with_plain_places(error.data());
}

std::string error_in_words() {
    try {
        throw;
    } catch (const base::Error& error) {
        return in_words(error);
    } catch (...) {
        return base::handled_failure().text;
    }
}

std::string one_line(const std::string& text) {
    constexpr std::size_t kLongest = 500;
    return base::shortened(base::printable(text), kLongest);
}

}  // namespace fretwork::studio

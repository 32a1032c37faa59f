// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/outlines/coloured_drawing.hpp>
#include <fretwork/pattern/pattern.hpp>
#include <fretwork/reduction/effective_properties.hpp>
#include <fretwork/simulation/detail/painting_palette.hpp>
#include <fretwork/tiling/painting/painting.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

namespace fretwork::simulation::detail {
namespace {

/// "left=right", as `0-1+1-6=3` and `red=0-1+1-6`.
struct Entry {
    std::string left;
    std::string right;  ///< empty: there was no =
};

std::vector<Entry> entries_of(const std::string& palette) {
    std::vector<Entry> entries;
    for (const std::string& word : base::split(palette, ',')) {
        const std::size_t equals = word.find('=');
        entries.push_back(equals == std::string::npos
                              ? Entry{word, ""}
                              : Entry{word.substr(0, equals), word.substr(equals + 1)});
    }
    return entries;
}

bool is_file(const std::string& palette) {
    return std::filesystem::path(palette).extension() == ".json";
}

std::vector<std::string> calibrated_patterns(const PaintingChoice& choice, const library::Library* library) {
    if (library == nullptr)
        throw base::InputError(choice.names.patterns, "",
                               choice.patterns + " needs patterns to choose from: give " +
                                   choice.names.palette + " or " + choice.names.library);
    std::vector<std::string> palette;
    for (const library::PatternEntry& entry : library->fitted_patterns()) {
        if (library->best_fit(entry.id)) palette.push_back(entry.id);
    }
    if (palette.empty())
        throw base::InputError(choice.names.library, "",
                               "has no calibrated pattern; name patterns with " + choice.names.palette);
    return palette;
}

using Properties = std::vector<std::pair<std::string, double>>;

/// Those that the library keeps; else they are computed.
Properties properties_of(const std::string& id, const PaintingGround& ground) {
    if (ground.library != nullptr) {
        try {
            Properties known = ground.library->properties(id);
            if (!known.empty()) return known;
        } catch (const base::InputError&) {
            // The library does not have the pattern.
        }
    }
    return reduction::property_values(reduction::effective_properties(
        ground.layout, pattern::parse_pattern_id(ground.layout, id), ground.setting));
}

double property_of(const std::string& id, const PaintingChoice& choice, const PaintingGround& ground) {
    std::vector<std::string> names;
    for (const auto& [name, value] : properties_of(id, ground)) {
        if (name == choice.property) return value;
        names.push_back(name);
    }
    throw base::InputError(choice.names.property, "",
                           base::unknown_name_message("property", choice.property, names));
}

}  // namespace

std::vector<std::string> checked_palette(const std::string& option, const pattern::NodeLayout& layout,
                                         const std::vector<std::string>& ids) {
    try {
        return tiling::make_palette(layout, ids);
    } catch (const base::InputError& error) {
        throw base::InputError(option, "", error.what());
    }
}

std::vector<std::string> palette_ids(const PaintingChoice& choice, const PaintingGround& ground) {
    if (choice.palette.empty()) return calibrated_patterns(choice, ground.library);
    if (is_file(choice.palette)) return tiling::read_painting(choice.palette, ground.layout).patterns;
    return checked_palette(choice.names.palette, ground.layout, base::split(choice.palette, ','));
}

std::vector<tiling::WeightedPattern> weighted_palette(const PaintingChoice& choice,
                                                      const PaintingGround& ground) {
    std::vector<tiling::WeightedPattern> weighted;
    if (choice.palette.empty() || is_file(choice.palette)) {
        for (std::string& id : palette_ids(choice, ground)) weighted.push_back({std::move(id), 1.0});
        return weighted;
    }
    std::vector<std::string> ids;
    for (const Entry& entry : entries_of(choice.palette)) {
        const auto weight = entry.right.empty() ? std::optional(1.0) : base::read_number<double>(entry.right);
        if (!weight || !(*weight > 0.0) || *weight > 1e9)
            throw base::InputError(
                choice.names.palette, "",
                "'" + entry.right + "' is no weight of " + entry.left + ": a number above zero is");
        ids.push_back(entry.left);
        weighted.push_back({entry.left, *weight});
    }
    ids = checked_palette(choice.names.palette, ground.layout, ids);
    for (std::size_t i = 0; i < ids.size(); ++i) weighted[i].pattern = ids[i];
    return weighted;
}

std::vector<tiling::GradedPattern> graded_palette(const PaintingChoice& choice,
                                                  const PaintingGround& ground) {
    const std::vector<std::string> ids = palette_ids(choice, ground);
    std::vector<tiling::GradedPattern> graded;
    // In equal parts of 0 to 1 the middle of a pattern's part is nearest; dithering needs both ends.
    const auto count = static_cast<double>(ids.size());
    const bool reaches_ends = choice.dithering != tiling::Dithering::None && ids.size() > 1;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const auto place = static_cast<double>(i);
        const double even = reaches_ends ? place / (count - 1.0) : (place + 0.5) / count;
        graded.push_back({ids[i], choice.property.empty() ? even : property_of(ids[i], choice, ground)});
    }
    return graded;
}

std::vector<std::pair<std::string, std::string>> coloured_palette(const PaintingChoice& choice,
                                                                  const PaintingGround& ground) {
    std::vector<std::pair<std::string, std::string>> palette;
    for (const Entry& entry : entries_of(choice.palette)) {
        try {
            if (entry.right.empty())
                throw base::InputError("'" + entry.left + "' has no pattern; write colour=ID, as in red=" +
                                       "0-1+1-6,#00f=0-5+5-6");
            palette.emplace_back(outlines::parse_colour(entry.left),
                                 tiling::make_palette(ground.layout, std::vector{entry.right}).front());
        } catch (const base::InputError& error) {
            throw base::InputError(choice.names.palette, "", error.what());
        }
    }
    return palette;
}

std::pair<double, double> wanted_range(const PaintingChoice& choice,
                                       const std::vector<tiling::GradedPattern>& palette) {
    if (choice.property.empty()) return {0.0, 1.0};
    const auto [low, high] = std::ranges::minmax(palette, {}, &tiling::GradedPattern::value);
    if (choice.range.empty()) return {low.value, high.value};
    const auto ends = base::split(choice.range, ',');
    const auto from = base::read_number<double>(ends.front());
    const auto to = base::read_number<double>(ends.back());
    if (ends.size() != 2 || !from || !to || !std::isfinite(*from) || !std::isfinite(*to))
        throw base::InputError(choice.names.range, "",
                               "'" + choice.range + "' is no range; the palette's is " +
                                   base::format_number(low.value) + "," + base::format_number(high.value));
    return {*from, *to};
}

}  // namespace fretwork::simulation::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/pattern/pattern.hpp>
#include <fretwork/reduction/effective_properties.hpp>
#include <fretwork/simulation/detail/painting_palette.hpp>
#include <fretwork/simulation/internal/colour_entries.hpp>
#include <fretwork/tiling/painting/painting.hpp>

#include <algorithm>

namespace fretwork::simulation::detail {
namespace {

using pattern::NamedPattern;

const std::string kPaletteEntry = "palette";

std::vector<NamedPattern> calibrated_patterns(const library::Library* library) {
    if (library == nullptr)
        throw base::InputError(kPaletteEntry, "", "has no patterns to choose from: name some, or a library");
    std::vector<NamedPattern> palette;
    for (const pattern::NamedPattern& entry : library->fitted_patterns()) {
        if (library->best_fit(entry.id)) palette.push_back({entry.id, entry.pattern});
    }
    if (palette.empty())
        throw base::InputError("library", "", "has no calibrated pattern; name patterns in the palette");
    return palette;
}

using Properties = std::vector<std::pair<std::string, double>>;

/// The properties in the library or, if it has none, computed ones.
Properties properties_of(const NamedPattern& pattern, const PaintingGround& ground) {
    if (ground.library != nullptr) {
        try {
            Properties known = ground.library->properties(pattern.id);
            if (!known.empty()) return known;
        } catch (const base::InputError&) {
            // The library does not have the pattern.
        }
    }
    return reduction::property_values(
        reduction::effective_properties(ground.layout, pattern.pattern, ground.setting));
}

double property_of(const NamedPattern& pattern, const std::string& property, const PaintingGround& ground) {
    std::vector<std::string> names;
    for (const auto& [name, value] : properties_of(pattern, ground)) {
        if (name == property) return value;
        names.push_back(name);
    }
    throw base::InputError("property", "", base::unknown_name_message("property", property, names));
}

}  // namespace

std::vector<NamedPattern> checked_palette(const std::string& entry, const pattern::NodeLayout& layout,
                                          const std::vector<std::string>& ids) {
    return base::located(entry, "", [&] { return tiling::make_palette(layout, ids); });
}

std::vector<NamedPattern> palette_of(const PaletteChoice& palette, const PaintingGround& ground) {
    if (!palette.ids.empty()) return checked_palette(kPaletteEntry, ground.layout, palette.ids);
    if (!palette.file.empty()) return tiling::read_painting(palette.file, ground.layout).patterns;
    return calibrated_patterns(ground.library);
}

std::vector<tiling::WeightedPattern> weighted_palette(const PaintAtRandom& choice,
                                                      const PaintingGround& ground) {
    std::vector<NamedPattern> patterns = palette_of(choice.palette, ground);
    if (!choice.weights.empty() && choice.weights.size() != patterns.size())
        throw base::InputError(kPaletteEntry, "",
                               std::to_string(choice.weights.size()) + " weights for " +
                                   std::to_string(patterns.size()) + " patterns");
    std::vector<tiling::WeightedPattern> weighted;
    for (NamedPattern& pattern : patterns) {
        const double weight = choice.weights.empty() ? 1.0 : choice.weights[weighted.size()];
        weighted.push_back({std::move(pattern), weight});
    }
    return weighted;
}

std::vector<tiling::GradedPattern> graded_palette(const PaintByField& choice, const PaintingGround& ground) {
    const std::vector<NamedPattern> patterns = palette_of(choice.palette, ground);
    std::vector<tiling::GradedPattern> graded;
    // Without a property, a pattern's value is the middle of its equal part of 0 to 1. With dithering, which
    // needs both 0 and 1, the values reach from 0 to 1.
    const auto count = static_cast<double>(patterns.size());
    const bool reaches_ends = choice.dithering != tiling::Dithering::None && patterns.size() > 1;
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        const auto place = static_cast<double>(i);
        const double even = reaches_ends ? place / (count - 1.0) : (place + 0.5) / count;
        graded.push_back({patterns[i], choice.property.empty()
                                           ? even
                                           : property_of(patterns[i], choice.property, ground)});
    }
    return graded;
}

std::vector<std::pair<std::string, NamedPattern>> coloured_palette(const PaintByColours& choice,
                                                                   const PaintingGround& ground) {
    std::vector<std::pair<std::string, std::string>> entries;
    std::vector<std::pair<std::string, NamedPattern>> palette;
    for (const auto& [colour, id] : choice.palette) {
        entries.emplace_back(colour, id);
        palette.emplace_back(colour, checked_palette(kPaletteEntry, ground.layout, {id}).front());
    }
    refuse_repeated_colours(entries, kPaletteEntry);
    return palette;
}

std::pair<double, double> wanted_range(const PaintByField& choice,
                                       const std::vector<tiling::GradedPattern>& palette) {
    if (choice.property.empty()) return {0.0, 1.0};
    if (choice.range) return *choice.range;
    const auto [low, high] = std::ranges::minmax(palette, {}, &tiling::GradedPattern::value);
    return {low.value, high.value};
}

}  // namespace fretwork::simulation::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/simulation/painting_choice.hpp>
#include <fretwork/tiling/painting.hpp>

#include <filesystem>

namespace fretwork::simulation {
namespace {

using tiling::Tessellation;

constexpr std::string_view kRandom = "random:";

/// A palette whose complaints name the option that it came from.
std::vector<std::string> palette_of(const std::string& option, const pattern::NodeLayout& layout,
                                    const std::vector<std::string>& ids) {
    try {
        return tiling::make_palette(layout, ids);
    } catch (const base::InputError& error) {
        throw base::InputError(option, "", error.what());
    }
}

/// The patterns that a random painting chooses from: those that are named, else those that the library has
/// calibrated.
std::vector<std::string> chosen_palette(const PaintingChoice& choice, const pattern::NodeLayout& layout,
                                        const library::Library* library) {
    if (std::filesystem::path(choice.palette).extension() == ".json")
        return tiling::read_painting(choice.palette, layout).patterns;
    if (!choice.palette.empty())
        return palette_of(choice.names.palette, layout, base::split(choice.palette, ','));
    if (!library)
        throw base::InputError(choice.names.patterns, choice.patterns,
                               "a painting by chance needs patterns to choose from: give " +
                                   choice.names.palette + " or " + choice.names.library);
    std::vector<std::string> palette;
    for (const library::PatternEntry& entry : library->patterns()) {
        if (library->best_fit(entry.id)) palette.push_back(entry.id);
    }
    if (palette.empty())
        throw base::InputError(choice.names.library, "",
                               "has no calibrated pattern; name patterns with " + choice.names.palette);
    return palette;
}

std::uint64_t parse_seed(std::string_view text, const std::string& option) {
    if (const auto seed = base::read_number<std::uint64_t>(text)) return *seed;
    throw base::InputError(option, "", "'" + std::string(text) + "' is no seed; random:1 has one");
}

}  // namespace

void check(const PaintingChoice& choice) {
    if (choice.palette.empty() || choice.patterns.starts_with(kRandom)) return;
    throw base::InputError(choice.names.palette, "",
                           "is what " + choice.names.patterns + " random:SEED chooses from, and " +
                               choice.names.patterns + " is " +
                               (choice.patterns.empty() ? "not given" : "'" + choice.patterns + "'"));
}

void paint(Tessellation& tessellation, const PaintingChoice& choice, const pattern::NodeLayout& layout,
           const library::Library* library) {
    if (choice.patterns.empty()) return;
    if (choice.patterns.starts_with(kRandom)) {
        const auto palette = chosen_palette(choice, layout, library);
        const auto seed =
            parse_seed(std::string_view(choice.patterns).substr(kRandom.size()), choice.names.patterns);
        return tiling::paint_randomly(tessellation, palette, seed);
    }
    if (std::filesystem::path(choice.patterns).extension() != ".json") {
        const auto palette = palette_of(choice.names.patterns, layout, {choice.patterns});
        return tiling::paint_uniformly(tessellation, palette.front());
    }
    try {
        tiling::paint(tessellation, tiling::read_painting(choice.patterns, layout));
    } catch (const base::InputError& error) {
        const std::string message = error.what();
        if (message.starts_with(choice.patterns)) throw;
        throw base::InputError(choice.patterns, "/tiles", message);
    }
}

}  // namespace fretwork::simulation

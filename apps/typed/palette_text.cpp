// SPDX-License-Identifier: GPL-3.0-or-later
#include "typed/palette_text.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/pattern/enumerate.hpp>
#include <fretwork/pattern/sample.hpp>
#include <fretwork/tiling/painting/painting.hpp>

#include <algorithm>
#include <set>

namespace fretwork::typed {
namespace {

using pattern::NamedPattern;
using pattern::NodeLayout;

constexpr std::size_t kMostPatterns = 20'000;

[[noreturn]] void refuse(const std::string& text, const std::string& problem) {
    throw base::InputError("--palette", "", "'" + text + "' " + problem);
}

std::vector<NamedPattern> named(const NodeLayout& layout, const std::vector<pattern::Pattern>& patterns) {
    std::vector<NamedPattern> result;
    for (const pattern::Pattern& own : patterns) result.push_back({pattern::pattern_id(layout, own), own});
    return result;
}

pattern::EnumerationOptions valid_patterns(const NodeLayout& layout, const base::Control& control) {
    return {.edges = pattern::default_edge_range(layout), .control = control};
}

std::vector<NamedPattern> all_of(const PaletteText& palette, const NodeLayout& layout) {
    const auto options = valid_patterns(layout, palette.control);
    if (const auto count = pattern::count_patterns(layout, options).total(); count > kMostPatterns)
        refuse(palette.text, "is " + std::to_string(count) + " patterns, where at most " +
                                 std::to_string(kMostPatterns) + " can be chosen from: take sample:N");
    return named(layout, pattern::enumerate_patterns(layout, options));
}

/// Different patterns, in the order in which they were drawn.
std::vector<NamedPattern> sample_of(const PaletteText& palette, const NodeLayout& layout) {
    const std::string number = palette.text.substr(palette.text.find(':') + 1);
    const bool is_number = !number.empty() && number.find_first_not_of("0123456789") == std::string::npos;
    const std::size_t wanted = is_number && number.size() <= 6 ? std::stoul(number) : 0;
    if (wanted < 1 || wanted > kMostPatterns)
        refuse(palette.text,
               "is not a sample: expected sample:N with N from 1 to " + std::to_string(kMostPatterns));
    pattern::PatternSampler sampler(layout, valid_patterns(layout, palette.control), palette.seed);
    std::set<std::string> known;
    std::vector<NamedPattern> result;
    // Draws may repeat. A layout with too few patterns ends at the limit of tries.
    for (std::size_t tries = 0; result.size() < wanted && tries < 100 * wanted + 10'000; ++tries) {
        for (NamedPattern& own : named(layout, sampler.draw(1))) {
            if (known.insert(own.id).second) result.push_back(std::move(own));
        }
    }
    return result;
}

}  // namespace

std::vector<NamedPattern> read_palette(const PaletteText& palette, const NodeLayout& layout,
                                       const library::Library* library) {
    if (palette.text == "all") return all_of(palette, layout);
    if (palette.text.starts_with("sample:")) return sample_of(palette, layout);
    if (palette.text == "library") {
        if (library == nullptr)
            refuse(palette.text, "needs a library, and the project has none: take all, sample:N or ids");
        library->check_layout(layout);
        return library->patterns();
    }
    return base::located("--palette", "",
                         [&] { return tiling::make_palette(layout, base::split(palette.text, ',')); });
}

}  // namespace fretwork::typed

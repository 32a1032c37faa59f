// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/outlines/coloured_drawing.hpp>
#include <fretwork/simulation/internal/colour_entries.hpp>

#include <cmath>
#include <optional>
#include <string_view>
#include <typed/painting_text.hpp>

namespace fretwork::typed {
namespace {

using tiling::Dithering;

constexpr std::string_view kRandom = "random:";
constexpr std::string_view kField = "field:";
constexpr std::string_view kImage = "image:";
constexpr std::string_view kColours = "colours:";

/// An entry "left=right", such as `0-1+1-6=3` or `red=0-1+1-6`.
struct Entry {
    std::string left;
    std::string right;  ///< empty: no =, or nothing after it
};

/// The words between commas. Commas in brackets, as in rgb(255, 0, 0), belong to a word.
std::vector<std::string> words_of_palette(const std::string& palette) {
    std::vector<std::string> words;
    for (std::string_view rest = palette;;) {
        const std::size_t end = base::find_outside(rest, ',');
        words.emplace_back(rest.substr(0, end));
        if (end == rest.size()) return words;
        rest.remove_prefix(end + 1);
    }
}

std::vector<Entry> entries_of(const std::string& palette) {
    std::vector<Entry> entries;
    for (const std::string& word : words_of_palette(palette)) {
        const std::size_t equals = word.find('=');
        entries.push_back(equals == std::string::npos
                              ? Entry{word, ""}
                              : Entry{word.substr(0, equals), word.substr(equals + 1)});
    }
    return entries;
}

bool is_file(const std::string& text) {
    return base::ending_of(text) == ".json";
}

class PaintingReader {
  public:
    explicit PaintingReader(const PaintingText& text) : text_(text) {}

    simulation::PaintingChoice read() const {
        check_what_goes_together();
        if (text_.patterns.empty()) return {};
        if (const auto seed = after(kRandom)) return by_chance(*seed);
        if (const auto expression = after(kField))
            return by_field({simulation::FieldExpression{*expression}});
        if (const auto image = after(kImage)) return by_field({simulation::FieldImage{*image}});
        if (const auto drawing = after(kColours)) return by_colours(*drawing);
        if (is_file(text_.patterns)) return simulation::PaintFromFile{text_.patterns};
        return simulation::PaintOnePattern{text_.patterns};
    }

  private:
    [[nodiscard]] std::string name(const char* entry) const { return text_.prefix + entry; }

    /// The rest of `patterns` after a prefix; none without the prefix.
    [[nodiscard]] std::optional<std::string> after(std::string_view prefix) const {
        if (!text_.patterns.starts_with(prefix)) return std::nullopt;
        return text_.patterns.substr(prefix.size());
    }

    [[noreturn]] void refuse(const char* entry, const std::string& what) const {
        throw base::InputError(name(entry), "",
                               what + ", and " + name("patterns") + " is " +
                                   (text_.patterns.empty() ? "not given" : "'" + text_.patterns + "'"));
    }

    void check_what_goes_together() const {
        const bool by_field = after(kField) || after(kImage);
        const bool chooses = by_field || after(kRandom) || after(kColours);
        const std::string patterns = name("patterns");
        if (!text_.palette.empty() && !chooses)
            refuse("palette", "is only for " + patterns + " random:SEED, field:, image: and colours:");
        if (text_.palette.empty() && after(kColours))
            refuse("palette", "has to give a pattern for each colour (red=ID,#00f=ID)");
        if (!text_.property.empty() && !by_field)
            refuse("property", "is for " + patterns + " field: and image:");
        if (!text_.range.empty() && text_.property.empty())
            throw base::InputError(name("range"), "",
                                   "is a range of " + name("property") + ", which is not given");
        if (text_.dither && !by_field) refuse("dither", "is for " + patterns + " field: and image:");
    }

    [[nodiscard]] simulation::PaletteChoice palette() const {
        if (text_.palette.empty()) return {};
        if (is_file(text_.palette)) return {.file = text_.palette};
        return {.ids = base::split(text_.palette, ',')};
    }

    [[nodiscard]] simulation::PaintAtRandom by_chance(const std::string& seed) const {
        const auto number = base::read_number<std::uint64_t>(seed);
        if (!number)
            throw base::InputError(name("patterns"), "",
                                   "'" + seed + "' is not a seed: expected a whole number, as in random:1");
        simulation::PaintAtRandom choice{.seed = *number, .palette = palette()};
        if (choice.palette.ids.empty()) return choice;
        choice.palette.ids.clear();
        for (const Entry& entry : entries_of(text_.palette)) {
            choice.palette.ids.push_back(entry.left);
            choice.weights.push_back(weight_of(entry));
        }
        return choice;
    }

    [[nodiscard]] double weight_of(const Entry& entry) const {
        constexpr double kLargest = 1e9;
        const auto weight = entry.right.empty() ? std::optional(1.0) : base::read_number<double>(entry.right);
        if (!weight || !(*weight > 0.0) || *weight > kLargest)
            throw base::InputError(
                name("palette"), "",
                "'" + entry.right + "' is not a weight of " + entry.left + ": expected a number above zero");
        return *weight;
    }

    [[nodiscard]] simulation::PaintByField by_field(
        std::variant<simulation::FieldExpression, simulation::FieldImage> field) const {
        return {.field = std::move(field),
                .palette = palette(),
                .property = text_.property,
                .range = range(),
                .dithering = text_.dither ? Dithering::ErrorDiffusion : Dithering::None};
    }

    [[nodiscard]] std::optional<std::pair<double, double>> range() const {
        if (text_.range.empty()) return std::nullopt;
        const auto ends = base::split(text_.range, ',');
        const auto from = base::read_number<double>(ends.front());
        const auto to = base::read_number<double>(ends.back());
        if (ends.size() != 2 || !from || !to || !std::isfinite(*from) || !std::isfinite(*to))
            throw base::InputError(name("range"), "",
                                   "'" + text_.range + "' is not LOW,HIGH: two numbers, such as 0.02,0.1");
        return std::pair(*from, *to);
    }

    [[nodiscard]] simulation::PaintByColours by_colours(const std::string& drawing) const {
        simulation::PaintByColours choice{.drawing = drawing, .palette = {}};
        std::vector<std::pair<std::string, std::string>> entries;  // each colour with its entry
        for (const Entry& entry : entries_of(text_.palette)) {
            if (entry.right.empty())
                throw base::InputError(name("palette"), "",
                                       "'" + entry.left + "' has no pattern; write colour=ID, as in red=" +
                                           "0-1+1-6,#00f=0-5+5-6");
            const std::string colour =
                base::located(name("palette"), "", [&] { return outlines::parse_colour(entry.left); });
            entries.emplace_back(colour, entry.left + "=" + entry.right);
            choice.palette.emplace_back(colour, entry.right);
        }
        simulation::refuse_repeated_colours(entries, name("palette"));
        return choice;
    }

    const PaintingText& text_;
};

}  // namespace

simulation::PaintingChoice read_painting(const PaintingText& text) {
    return PaintingReader(text).read();
}

}  // namespace fretwork::typed

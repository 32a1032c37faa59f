// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/drawings/detail/furniture.hpp>
#include <fretwork/exports/space/detail/picture_legend.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace fretwork::exports::detail {
namespace {

/// The usual letters of five by seven dots: columns from left to right, the lowest bit on top. Those that the
/// titles, units and numbers of fields are made of.
struct Glyph {
    char letter;
    std::array<std::uint8_t, 5> columns;
};
constexpr Glyph kGlyphs[] = {{'%', {0x23, 0x13, 0x08, 0x64, 0x62}}, {'+', {0x08, 0x08, 0x3E, 0x08, 0x08}},
                             {'-', {0x08, 0x08, 0x08, 0x08, 0x08}}, {'.', {0x00, 0x60, 0x60, 0x00, 0x00}},
                             {'0', {0x3E, 0x51, 0x49, 0x45, 0x3E}}, {'1', {0x00, 0x42, 0x7F, 0x40, 0x00}},
                             {'2', {0x42, 0x61, 0x51, 0x49, 0x46}}, {'3', {0x21, 0x41, 0x45, 0x4B, 0x31}},
                             {'4', {0x18, 0x14, 0x12, 0x7F, 0x10}}, {'5', {0x27, 0x45, 0x45, 0x45, 0x39}},
                             {'6', {0x3C, 0x4A, 0x49, 0x49, 0x30}}, {'7', {0x01, 0x71, 0x09, 0x05, 0x03}},
                             {'8', {0x36, 0x49, 0x49, 0x49, 0x36}}, {'9', {0x06, 0x49, 0x49, 0x29, 0x1E}},
                             {':', {0x00, 0x36, 0x36, 0x00, 0x00}}, {'A', {0x7E, 0x11, 0x11, 0x11, 0x7E}},
                             {'B', {0x7F, 0x49, 0x49, 0x49, 0x36}}, {'D', {0x7F, 0x41, 0x41, 0x22, 0x1C}},
                             {'L', {0x7F, 0x40, 0x40, 0x40, 0x40}}, {'M', {0x7F, 0x02, 0x0C, 0x02, 0x7F}},
                             {'N', {0x7F, 0x04, 0x08, 0x10, 0x7F}}, {'P', {0x7F, 0x09, 0x09, 0x09, 0x06}},
                             {'S', {0x46, 0x49, 0x49, 0x49, 0x31}}, {'T', {0x01, 0x01, 0x7F, 0x01, 0x01}},
                             {'a', {0x20, 0x54, 0x54, 0x54, 0x78}}, {'b', {0x7F, 0x48, 0x44, 0x44, 0x38}},
                             {'c', {0x38, 0x44, 0x44, 0x44, 0x20}}, {'d', {0x38, 0x44, 0x44, 0x48, 0x7F}},
                             {'e', {0x38, 0x54, 0x54, 0x54, 0x18}}, {'f', {0x08, 0x7E, 0x09, 0x01, 0x02}},
                             {'g', {0x0C, 0x52, 0x52, 0x52, 0x3E}}, {'h', {0x7F, 0x08, 0x04, 0x04, 0x78}},
                             {'i', {0x00, 0x44, 0x7D, 0x40, 0x00}}, {'j', {0x20, 0x40, 0x44, 0x3D, 0x00}},
                             {'k', {0x7F, 0x10, 0x28, 0x44, 0x00}}, {'l', {0x00, 0x41, 0x7F, 0x40, 0x00}},
                             {'m', {0x7C, 0x04, 0x18, 0x04, 0x78}}, {'n', {0x7C, 0x08, 0x04, 0x04, 0x78}},
                             {'o', {0x38, 0x44, 0x44, 0x44, 0x38}}, {'p', {0x7C, 0x14, 0x14, 0x14, 0x08}},
                             {'r', {0x7C, 0x08, 0x04, 0x04, 0x08}}, {'s', {0x48, 0x54, 0x54, 0x54, 0x20}},
                             {'t', {0x04, 0x3F, 0x44, 0x40, 0x20}}, {'u', {0x3C, 0x40, 0x40, 0x20, 0x7C}},
                             {'x', {0x44, 0x28, 0x10, 0x28, 0x44}}};
constexpr int kLetter = 6;  // dots from one letter to the next
constexpr int kHeight = 7;

struct Rgb {
    std::uint8_t red, green, blue;
};

class Pixels {
  public:
    Pixels(std::vector<std::uint8_t> bytes, PixelSize size) : bytes_(std::move(bytes)), size_(size) {}

    void fill(int x, int y, PixelSize box, Rgb colour) {
        for (int row = std::max(y, 0); row < std::min(y + box.height, size_.height); ++row) {
            for (int column = std::max(x, 0); column < std::min(x + box.width, size_.width); ++column) {
                const std::size_t at = 4 * size_.at(column, row);
                bytes_[at] = colour.red;
                bytes_[at + 1] = colour.green;
                bytes_[at + 2] = colour.blue;
                bytes_[at + 3] = 255;
            }
        }
    }

    /// @param dot  how many pixels a dot of the letters is wide
    void write(int x, int y, std::string_view text, int dot) {
        write_letters(x, y, text, {dot, dot, {0xff, 0xff, 0xff}});
        write_letters(x, y, text, {dot, 0, {0x22, 0x28, 0x2e}});
    }

    std::vector<std::uint8_t> bytes() && { return std::move(bytes_); }

  private:
    struct Pen {
        int dot;  ///< how many pixels a dot of the letters is wide
        int rim;  ///< pixels around it
        Rgb colour;
    };
    void write_letters(int x, int y, std::string_view text, const Pen& pen) {
        const int side = pen.dot + 2 * pen.rim;
        for (const char letter : text) {
            const auto* glyph = std::ranges::find(kGlyphs, letter, &Glyph::letter);
            for (int column = 0; glyph != std::end(kGlyphs) && column < 5; ++column) {
                for (int row = 0; row < kHeight; ++row) {
                    if ((glyph->columns[column] >> row & 1) != 0)
                        fill(x + pen.dot * column - pen.rim, y + pen.dot * row - pen.rim, {side, side},
                             pen.colour);
                }
            }
            x += kLetter * pen.dot;
        }
    }

    std::vector<std::uint8_t> bytes_;
    PixelSize size_;
};

/// Reads "#rrggbb".
Rgb rgb(const std::string& colour) {
    const auto byte = [&](std::size_t at) {
        return static_cast<std::uint8_t>(std::stoi(colour.substr(at, 2), nullptr, 16));
    };
    return {byte(1), byte(3), byte(5)};
}

/// The lengths of a legend, pixels.
struct Measures {
    explicit Measures(PixelSize size) : dot(std::max(1, size.width / 800)) {}
    int dot;
    int margin = 8 * dot;
    int bar = 10 * dot;
    int line = (kHeight + 4) * dot;
    int height = 3 * line + bar + 2 * margin;
};

}  // namespace

int legend_height(PixelSize size) {
    constexpr int kSmallest = 300;  // pixels wide; below, the legend would be as large as the surface
    return size.width < kSmallest || size.height < kSmallest ? 0 : Measures(size).height;
}

std::vector<std::uint8_t> with_legend(std::vector<std::uint8_t> pixels, PixelSize size,
                                      const Legend& legend) {
    if (legend_height(size) == 0) return pixels;
    const BarScene::Field& field = legend.field;
    const Measures measures(size);
    const int dot = measures.dot;
    const ValueRange range = value_range(field.values);
    const auto beyond = largest_beyond(field.values, range);
    std::string title = field.title + " " + field.unit;
    if (beyond) title += " up to " + short_number(field.factor * *beyond) + "  ";
    const std::string from = short_number(field.factor * range.from);
    const std::string to = short_number(field.factor * range.to);
    const int width = kLetter * dot * static_cast<int>(std::max<std::size_t>(title.size(), 24));
    const int line = measures.line;
    const int x = 2 * measures.margin;
    const int y = size.height - measures.height + measures.margin;
    pixels.resize(4 * size.count());
    Pixels drawn(std::move(pixels), size);
    drawn.write(x, y, title, dot);
    if (beyond) {
        const int square = kHeight * dot;
        drawn.fill(x + kLetter * dot * static_cast<int>(title.size()) - square, y, {square, square},
                   rgb(kBeyondColour));
    }
    for (int column = 0; column < width; ++column) {
        const double share = (column + 0.5) / width;
        drawn.fill(x + column, y + line, {1, measures.bar},
                   rgb(value_colour(range.from + share * (range.to - range.from), range)));
    }
    const int below = y + line + measures.bar + 4 * dot;
    drawn.write(x, below, from, dot);
    drawn.write(x + width - kLetter * dot * static_cast<int>(to.size()), below, to, dot);
    drawn.write(x, below + line, legend.note, dot);
    return std::move(drawn).bytes();
}

}  // namespace fretwork::exports::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/drawings/detail/furniture.hpp>
#include <fretwork/exports/space/detail/lettering.hpp>
#include <fretwork/exports/space/detail/picture_legend.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace fretwork::exports::detail {
namespace {

using LegendRgb = std::array<std::uint8_t, 3>;

/// A grey that is as far from white as from black: pictures are put on slides of either.
constexpr LegendRgb kInk = {0x78, 0x80, 0x89};

/// A picture to write and to draw on.
class LegendPixels {
  public:
    LegendPixels(std::vector<std::uint8_t> bytes, PixelSize size) : bytes_(std::move(bytes)), size_(size) {}

    void fill(int x, int y, PixelSize box, const LegendRgb& colour) {
        for (int row = y; row < y + box.height; ++row)
            for (int column = x; column < x + box.width; ++column) cover(column, row, 255, colour);
    }

    /// Write a text; its box has the upper left corner (x, y).
    void write(int x, int y, const LetteredText& text) {
        for (int row = 0; row < text.height; ++row)
            for (int column = 0; column < text.width; ++column)
                cover(x + column, y + row, text.coverage[static_cast<std::size_t>(row * text.width + column)],
                      kInk);
    }

    std::vector<std::uint8_t> bytes() && { return std::move(bytes_); }

  private:
    /// Lays a colour over a pixel.
    void cover(int x, int y, int opacity, const LegendRgb& colour) {
        if (opacity == 0 || x < 0 || y < 0 || x >= size_.width || y >= size_.height) return;
        std::uint8_t* pixel = &bytes_[4 * size_.at(x, y)];
        const double above = opacity / 255.0;
        const double below = pixel[3] / 255.0 * (1.0 - above);
        for (std::size_t c = 0; c < 3; ++c)
            pixel[c] = static_cast<std::uint8_t>(
                std::lround((above * colour[c] + below * pixel[c]) / (above + below)));
        pixel[3] = static_cast<std::uint8_t>(std::lround(255.0 * (above + below)));
    }

    std::vector<std::uint8_t> bytes_;
    PixelSize size_;
};

/// The lengths of a legend, pixels.
struct Measures {
    explicit Measures(PixelSize size) : letters(std::max(11, std::min(size.width / 75, size.height / 30))) {}
    int letters;                 ///< size
    int line = 3 * letters / 2;  ///< from one line of text to the next
    int margin = letters;
    int bar = letters;
    int height = 3 * line + bar + 2 * margin;
};

constexpr int kValues = 5;  // values below the colours

}  // namespace

int legend_height(PixelSize size) {
    constexpr int kSmallest = 300;  // pixels; below this size, the legend would be as large as the surface
    return size.width < kSmallest || size.height < kSmallest ? 0 : Measures(size).height;
}

std::vector<std::uint8_t> with_legend(std::vector<std::uint8_t> pixels, PixelSize size,
                                      const Legend& legend) {
    if (legend_height(size) == 0) return pixels;
    const BarScene::Field& field = legend.field;
    const Measures measures(size);
    const Lettering lettering(measures.letters);
    const ValueRange range = value_range(field.values);
    const int x = 2 * measures.margin;
    const int y = size.height - measures.height + measures.margin;
    const int width = std::min(size.width - 2 * x, 24 * measures.letters);
    pixels.resize(4 * size.count());
    LegendPixels drawn(std::move(pixels), size);
    const LetteredText title = lettering.set(field.title + " in " + field.unit);
    drawn.write(x, y, title);
    if (const auto beyond = largest_beyond(field.values, range)) {
        const int square = measures.letters;
        const int at = x + title.width + 2 * measures.letters;
        drawn.fill(at, y + (title.height - square) / 2, {square, square}, colour_bytes(kBeyondColour));
        drawn.write(at + 3 * square / 2, y,
                    lettering.set("beyond, up to " + short_number(field.factor * *beyond)));
    }
    const int bar = y + measures.line;
    for (int column = 0; column < width; ++column) {
        const double share = (column + 0.5) / width;
        drawn.fill(x + column, bar, {1, measures.bar},
                   colour_bytes(value_colour(range.from + share * (range.to - range.from), range)));
    }
    const int below = bar + measures.bar + measures.letters / 4;
    for (int i = 0; i < kValues; ++i) {
        const double share = static_cast<double>(i) / (kValues - 1);
        const LetteredText value =
            lettering.set(short_number(field.factor * (range.from + share * (range.to - range.from))));
        // The first value begins at the left end of the colours, and the last value ends at the right end.
        drawn.write(x + static_cast<int>(std::lround(share * (width - value.width))), below, value);
    }
    drawn.write(x, below + measures.line, lettering.set(legend.note));
    return std::move(drawn).bytes();
}

}  // namespace fretwork::exports::detail

// SPDX-License-Identifier: GPL-3.0-or-later
// Text in pictures made of pixels.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

namespace fretwork::exports::detail {

/// A text as coverage of pixels, 0 to 255, row by row from the upper left.
struct LetteredText {
    int width = 0;   ///< pixels
    int height = 0;  ///< pixels; the same for all texts of a lettering
    std::vector<std::uint8_t> coverage;
};

/// DejaVu Sans at one size. The font is part of the library, and FreeType reads it.
class Lettering {
  public:
    /// @param size  of the letters, pixels
    explicit Lettering(int size);
    ~Lettering();
    Lettering(const Lettering&) = delete;
    Lettering& operator=(const Lettering&) = delete;

    /// A text in UTF-8 on one line. Letters that the font does not have are boxes.
    [[nodiscard]] LetteredText set(std::string_view text) const;

  private:
    struct Font;
    std::unique_ptr<Font> font_;
};

}  // namespace fretwork::exports::detail

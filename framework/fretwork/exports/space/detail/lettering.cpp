// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/internal/utf8.hpp>
#include <fretwork/exports/detail/picture_font.hpp>
#include <fretwork/exports/space/detail/lettering.hpp>

#include <algorithm>
#include <ft2build.h>
#include FT_FREETYPE_H
#include <string>

namespace fretwork::exports::detail {

struct Lettering::Font {
    FT_Library library = nullptr;
    FT_Face face = nullptr;

    Font() = default;
    Font(const Font&) = delete;
    Font& operator=(const Font&) = delete;
    ~Font() {
        if (face != nullptr) FT_Done_Face(face);
        if (library != nullptr) FT_Done_FreeType(library);
    }
    [[nodiscard]] int ascender() const { return static_cast<int>(face->size->metrics.ascender >> 6); }
    [[nodiscard]] int height() const {
        return ascender() - static_cast<int>(face->size->metrics.descender >> 6);
    }
};

namespace {

void require_freetype(FT_Error error, const char* what) {
    if (error != 0)
        throw base::NumericalError("FreeType cannot " + std::string(what) + " (error " +
                                   std::to_string(error) + ")");
}

/// The code points of a text in UTF-8; bytes that are no UTF-8 count as they are.
std::vector<FT_ULong> code_points(std::string_view text) {
    std::vector<FT_ULong> points;
    while (!text.empty()) {
        const base::Character character = base::first_character(text);
        points.push_back(character.code.value_or(static_cast<unsigned char>(text.front())));
        text.remove_prefix(character.bytes);
    }
    return points;
}

/// Adds a glyph's coverage; what lies outside is left out.
void add_glyph(LetteredText& text, const FT_Bitmap& glyph, int left, int top) {
    for (int row = 0; row < static_cast<int>(glyph.rows); ++row) {
        for (int column = 0; column < static_cast<int>(glyph.width); ++column) {
            const int x = left + column;
            const int y = top + row;
            if (x < 0 || y < 0 || x >= text.width || y >= text.height) continue;
            std::uint8_t& there = text.coverage[static_cast<std::size_t>(y * text.width + x)];
            there = std::max(there, glyph.buffer[row * glyph.pitch + column]);
        }
    }
}

}  // namespace

Lettering::Lettering(int size) : font_(std::make_unique<Font>()) {
    require_freetype(FT_Init_FreeType(&font_->library), "start");
    const auto bytes = picture_font();
    require_freetype(
        FT_New_Memory_Face(font_->library, bytes.data(), static_cast<FT_Long>(bytes.size()), 0, &font_->face),
        "read its font");
    require_freetype(FT_Set_Pixel_Sizes(font_->face, 0, static_cast<FT_UInt>(size)), "set the size");
}

Lettering::~Lettering() = default;

LetteredText Lettering::set(std::string_view text) const {
    const std::vector<FT_ULong> points = code_points(text);
    const auto load = [&](FT_ULong point, FT_Int32 flags) {
        require_freetype(FT_Load_Char(font_->face, point, FT_LOAD_TARGET_LIGHT | flags), "read a letter");
        return font_->face->glyph;
    };
    LetteredText set;
    for (const FT_ULong point : points) set.width += static_cast<int>(load(point, 0)->advance.x >> 6);
    set.height = font_->height();
    set.coverage.assign(static_cast<std::size_t>(set.width) * static_cast<std::size_t>(set.height), 0);
    int x = 0;
    for (const FT_ULong point : points) {
        const FT_GlyphSlot glyph = load(point, FT_LOAD_RENDER);
        add_glyph(set, glyph->bitmap, x + glyph->bitmap_left, font_->ascender() - glyph->bitmap_top);
        x += static_cast<int>(glyph->advance.x >> 6);
    }
    return set;
}

}  // namespace fretwork::exports::detail

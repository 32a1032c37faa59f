// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/provenance.hpp>
#include <fretwork/exports/space/detail/png_text.hpp>

#include <png.h>

namespace fretwork::exports::detail {

namespace {

[[noreturn]] void refuse(png_structp, png_const_charp message) {
    throw base::IoError(std::string("the picture cannot be written: ") + message);
}
void ignore(png_structp, png_const_charp) {}

void append(png_structp png, png_bytep bytes, std::size_t count) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}
void flush(png_structp) {}

/// Owns what libpng has allocated.
struct PngWriter {
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, refuse, ignore);
    png_infop info = png_create_info_struct(png);
    PngWriter() = default;
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;
    ~PngWriter() { png_destroy_write_struct(&png, &info); }
};

}  // namespace

std::string png_text(PixelSize size, const std::vector<std::uint8_t>& bytes) {
    PngWriter writer;
    std::string text;
    png_set_write_fn(writer.png, &text, append, flush);
    png_set_IHDR(writer.png, writer.info, size.width, size.height, 8, PNG_COLOR_TYPE_RGB_ALPHA,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
    // By this entry, the program recognizes its own files, which it may replace.
    std::string key = "Software";
    std::string value(base::kMadeBy);
    png_text_struct software{};
    software.compression = PNG_TEXT_COMPRESSION_NONE;
    software.key = key.data();
    software.text = value.data();
    software.text_length = value.size();
    png_set_text(writer.png, writer.info, &software, 1);
    png_write_info(writer.png, writer.info);
    for (int y = 0; y < size.height; ++y) png_write_row(writer.png, bytes.data() + 4 * size.at(0, y));
    png_write_end(writer.png, writer.info);
    return text;
}

}  // namespace fretwork::exports::detail

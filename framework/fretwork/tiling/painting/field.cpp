// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/geometry/internal/place_limits.hpp>
#include <fretwork/tiling/painting/field.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <muParser.h>
#include <png.h>

namespace fretwork::tiling {
namespace {

using geometry::Point2;

/// A point as shares of the box, from 0 to 1 across the box.
Point2 share_at(const geometry::Box& box, Point2 point) {
    const auto share = [](double low, double high, double value) {
        return high > low ? (value - low) / (high - low) : 0.5;
    };
    return {share(box.xmin, box.xmax, point.x), share(box.ymin, box.ymax, point.y)};
}

/// Refuse coordinates from which no pixel follows.
void check_places(const geometry::Box& box, const std::vector<Point2>& points) {
    const auto check = [](const std::string& name, Point2 place) {
        if (!geometry::is_within_limits(place))
            throw base::InputError(geometry::beyond_limits_text(name, place));
    };
    check("the lower left corner of the box", {box.xmin, box.ymin});
    check("the upper right corner of the box", {box.xmax, box.ymax});
    for (std::size_t i = 0; i < points.size(); ++i) check("point " + std::to_string(i), points[i]);
}

struct GreyImage {
    std::size_t width = 0;
    std::size_t height = 0;
    /// The grey value, encoded as in sRGB, and the opacity of each pixel, row by row from the top.
    std::vector<std::uint8_t> pixels;

    /// The darkness on a white ground. Encoded values are mixed, as in browsers and drawing programs.
    [[nodiscard]] double darkness(std::size_t row, std::size_t column) const {
        const std::size_t at = 2 * (row * width + column);
        return (1.0 - pixels[at] / 255.0) * (pixels[at + 1] / 255.0);
    }
};

/// The largest number of pixels, more than any surface needs; more pixels could fill the memory.
constexpr std::size_t kMostPixels = 100'000'000;

/// True if the last chunk is complete, which libpng does not check, because it stops reading after the last
/// pixel.
bool has_png_end(std::string_view bytes) {
    constexpr std::size_t kSignature = 8;
    constexpr std::size_t kFrame = 12;  // bytes of a chunk around its data: length, type, checksum
    for (std::size_t at = kSignature; at + kFrame <= bytes.size();) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) length = 256 * length + static_cast<unsigned char>(bytes[at + i]);
        if (length > bytes.size() - at - kFrame) return false;
        if (bytes.substr(at + 4, 4) == "IEND") return true;
        at += kFrame + length;
    }
    return false;
}

GreyImage parse_image(std::string_view bytes, const std::string& source) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    const auto fail = [&](const std::string& what) {
        png_image_free(&image);
        throw base::InputError(source, "", "cannot be read as a PNG image: " + what);
    };
    if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) fail(image.message);
    if (std::size_t{image.width} * image.height > kMostPixels)
        fail("it has more than " + std::to_string(kMostPixels) + " pixels");
    image.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // otherwise, 16 bits without a gamma are taken as linear light
    image.format = PNG_FORMAT_GA;
    GreyImage read{image.width, image.height, {}};
    read.pixels.resize(PNG_IMAGE_SIZE(image));
    if (png_image_finish_read(&image, nullptr, read.pixels.data(), 0, nullptr) == 0) fail(image.message);
    if (!has_png_end(bytes))
        throw base::InputError(source, "", "cannot be read as a PNG image: its end is missing");
    return read;
}

}  // namespace

std::vector<double> expression_values(const std::string& expression, const geometry::Box& box,
                                      const std::vector<Point2>& points) {
    Point2 place;
    Point2 share;
    const auto fail = [&](const std::string& what) {
        throw base::InputError("'" + base::shortened(expression, 80) + "': " + what);
    };
    std::vector<double> values;
    try {
        mu::Parser parser;
        parser.DefineVar("x", &place.x);
        parser.DefineVar("y", &place.y);
        parser.DefineVar("u", &share.x);
        parser.DefineVar("v", &share.y);
        parser.DefineConst("pi", std::acos(-1.0));
        parser.SetExpr(expression);
        if (points.empty()) (void)parser.Eval();  // which reads the expression
        for (const Point2& point : points) {
            place = point;
            share = share_at(box, point);
            values.push_back(parser.Eval());
        }
    } catch (const mu::ParserError& error) {
        std::string complaint = base::shortened(error.GetMsg(), 120);
        if (complaint.ends_with('.')) complaint.pop_back();
        fail(complaint + "; there are the variables x, y (metres), u and v (0 to 1)");
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i]))
            fail("has no finite value at x = " + base::format_number(points[i].x) +
                 ", y = " + base::format_number(points[i].y));
    }
    return values;
}

std::vector<double> image_values(const std::filesystem::path& image, const geometry::Box& box,
                                 const std::vector<Point2>& points) {
    return image_values(base::read_text_file(image), image.string(), box, points);
}

std::vector<double> image_values(std::string_view png, const std::string& source, const geometry::Box& box,
                                 const std::vector<Point2>& points) {
    check_places(box, points);
    const GreyImage grey = parse_image(png, source);
    const auto pixel = [](double share, std::size_t count) {
        const double place = std::floor(share * static_cast<double>(count));
        return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(count - 1)));
    };
    std::vector<double> values;
    for (const Point2& point : points) {
        const Point2 share = share_at(box, point);
        const std::size_t row = pixel(1.0 - share.y, grey.height);
        values.push_back(grey.darkness(row, pixel(share.x, grey.width)));
    }
    return values;
}

}  // namespace fretwork::tiling

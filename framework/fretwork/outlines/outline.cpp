// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/geometry/box.hpp>
#include <fretwork/geometry/internal/place_limits.hpp>
#include <fretwork/outlines/detail/outline_readers.hpp>
#include <fretwork/outlines/detail/remarks.hpp>
#include <fretwork/outlines/outline.hpp>
#include <fretwork/outlines/outline_check.hpp>

#include <algorithm>
#include <array>

namespace fretwork::outlines {
namespace {

using geometry::Point2;
using geometry::Polygon;

enum class Orientation { Counterclockwise, Clockwise };

/// Orient a polygon and keep its first point. The area of a simple polygon can be zero only by rounding.
void orient(Polygon& polygon, Orientation wanted) {
    const bool is_counterclockwise = geometry::signed_area(polygon) > 0;
    if (is_counterclockwise != (wanted == Orientation::Counterclockwise))
        std::reverse(polygon.begin() + 1, polygon.end());
}

/// Refuse coordinates whose products, such as areas, may be too large for a number.
void check_sizes(const std::vector<Polygon>& loops) {
    for (std::size_t loop = 0; loop < loops.size(); ++loop) {
        for (std::size_t i = 0; i < loops[loop].size(); ++i) {
            const Point2& place = loops[loop][i];
            if (geometry::is_within_limits(place)) continue;
            const std::string name = "point " + std::to_string(i) + " of " +
                                     (loop == 0 ? "the boundary" : "hole " + std::to_string(loop - 1));
            throw base::GeometryError(geometry::beyond_limits_text(name, place) + "; is the unit right?");
        }
    }
}

}  // namespace

double area_of(const Outline& outline) {
    double area = geometry::signed_area(outline.boundary);
    for (const Polygon& hole : outline.holes) area += geometry::signed_area(hole);
    return area;
}

Outline make_outline(Polygon boundary, std::vector<Polygon> holes) {
    std::vector<Polygon> loops{std::move(boundary)};
    for (Polygon& hole : holes) loops.push_back(std::move(hole));
    check_sizes(loops);
    if (const auto flaw = outline_flaw(loops, {})) throw base::GeometryError(*flaw);
    Outline outline;
    for (std::size_t loop = 0; loop < loops.size(); ++loop) {
        orient(loops[loop], loop == 0 ? Orientation::Counterclockwise : Orientation::Clockwise);
        if (loop == 0)
            outline.boundary = std::move(loops[loop]);
        else
            outline.holes.push_back(std::move(loops[loop]));
    }
    return outline;
}

namespace {

struct Reader {
    std::string_view ending;
    OutlineFile (*read)(const std::filesystem::path&);
};

template <auto read_loops>
OutlineFile outline_of_loops(const std::filesystem::path& path) {
    return {{detail::outline_of(read_loops(path))}, {}};
}

OutlineFile read_json(const std::filesystem::path& path) {
    return {{parse_outline(base::read_text_file(path), path.string())}, {}};
}

constexpr std::array<Reader, 6> kReaders = {{{".json", read_json},
                                             {".svg", detail::read_svg_outlines},
                                             {".dxf", detail::read_dxf_outlines},
                                             {".obj", outline_of_loops<detail::read_obj_loops>},
                                             {".ply", outline_of_loops<detail::read_ply_loops>},
                                             {".off", outline_of_loops<detail::read_off_loops>}}};

geometry::Box box_of_all(const std::vector<Outline>& parts) {
    geometry::Box box = geometry::box_of(parts.front().boundary);
    for (const Outline& part : parts) box = geometry::united(box, geometry::box_of(part.boundary));
    return box;
}

}  // namespace

OutlineFile scaled_to_width(OutlineFile file, double width) {
    const double factor = width / box_of_all(file.parts).width();
    const auto scale = [factor](geometry::Polygon& loop) {
        for (Point2& point : loop) point = {factor * point.x, factor * point.y};
        geometry::remove_repeated_points(loop, 0.0);
    };
    for (Outline& part : file.parts) {
        scale(part.boundary);
        std::ranges::for_each(part.holes, scale);
        part = make_outline(std::move(part.boundary), std::move(part.holes));
    }
    return file;
}

OutlineFile read_outline_file(const std::filesystem::path& path) {
    const std::string ending = base::ending_of(path);
    for (const Reader& reader : kReaders) {
        if (reader.ending == ending)
            return base::with_source(path.string(), [&] { return reader.read(path); });
    }
    throw base::InputError(
        path.string(), "",
        "an outline is a .json, .svg, .dxf, .obj, .ply or .off file, and this ends in '" + ending + "'");
}

Outline read_outline(const std::filesystem::path& path) {
    return std::move(read_outline_file(path).parts.front());
}

OutlineFile take_parts(OutlineFile file, std::string_view which) {
    const std::size_t count = file.parts.size();
    if (which == "all") return file;
    const auto number = which == "largest" ? 1 : base::read_number<std::size_t>(which).value_or(0);
    if (number < 1 || number > count)
        throw base::InputError("part '" + base::shortened(base::printable(which), 20) +
                               "' is none of largest, all, 1 .. " + std::to_string(count));
    if (count == 1) return file;
    file.parts = {std::move(file.parts[number - 1])};
    file.remarks.push_back("part " + std::to_string(number) + " of " + std::to_string(count) + " taken" +
                           (which == "largest" ? ", the largest" : ""));
    return file;
}

std::string size_text(const std::vector<Outline>& parts) {
    const geometry::Box box = box_of_all(parts);
    return detail::in_millimetres(box.width()) + " x " + detail::in_millimetres(box.height()) + " mm";
}

}  // namespace fretwork::outlines

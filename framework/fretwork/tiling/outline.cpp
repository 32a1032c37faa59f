// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/file.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/tiling/detail/outline_check.hpp>
#include <fretwork/tiling/detail/outline_readers.hpp>
#include <fretwork/tiling/outline.hpp>

#include <algorithm>
#include <array>
#include <cctype>

namespace fretwork::tiling {
namespace {

using pattern::Polygon;

enum class Orientation { Counterclockwise, Clockwise };

/// The first point stays the first. A simple polygon's area is not zero but for rounding.
void orient(Polygon& polygon, Orientation wanted) {
    const bool is_counterclockwise = pattern::signed_area(polygon) > 0;
    if (is_counterclockwise != (wanted == Orientation::Counterclockwise))
        std::reverse(polygon.begin() + 1, polygon.end());
}

}  // namespace

Outline make_outline(Polygon boundary, std::vector<Polygon> holes) {
    std::vector<Polygon> loops{std::move(boundary)};
    for (Polygon& hole : holes) loops.push_back(std::move(hole));
    if (const auto flaw = detail::outline_flaw(loops, {})) throw base::GeometryError(*flaw);
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
    Outline (*read)(const std::filesystem::path&);
};

template <auto read_loops>
Outline outline_of_loops(const std::filesystem::path& path) {
    return detail::outline_of(read_loops(path));
}

Outline read_json(const std::filesystem::path& path) {
    return parse_outline(base::read_text_file(path), path.string());
}

constexpr std::array<Reader, 6> kReaders = {{{".json", read_json},
                                             {".svg", outline_of_loops<detail::read_svg_loops>},
                                             {".dxf", outline_of_loops<detail::read_dxf_loops>},
                                             {".obj", outline_of_loops<detail::read_obj_loops>},
                                             {".ply", outline_of_loops<detail::read_ply_loops>},
                                             {".off", outline_of_loops<detail::read_off_loops>}}};

}  // namespace

Outline read_outline(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    for (const Reader& reader : kReaders) {
        if (reader.ending != ending) continue;
        try {
            return reader.read(path);
        } catch (const base::GeometryError& error) {
            const std::string message = error.what();  // some readers have named the file already
            if (message.starts_with(path.string())) throw;
            throw base::GeometryError(path.string(), "", message);
        }
    }
    throw base::InputError(
        path.string(), "",
        "an outline is a .json, .svg, .dxf, .obj, .ply or .off file, and this ends in '" + ending + "'");
}

}  // namespace fretwork::tiling

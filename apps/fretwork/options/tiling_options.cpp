// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/tiling_options.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/quantity.hpp>

#include <map>

namespace fretwork::app {
namespace {

constexpr LengthOption kEdgeLength{"--edge-length", 1.0};

const std::map<std::string, tiling::Narrow> kNarrow = {
    {"refine", tiling::Narrow::Refine}, {"merge", tiling::Narrow::Merge}, {"refuse", tiling::Narrow::Refuse}};

}  // namespace

double read_length(const LengthOption& option, const std::string& text) {
    base::refuse_missing_unit(option.name, text, option.large);
    return base::located(option.name, "", [&] { return base::parse_length(text); });
}

void add_tiling_options(CLI::App& verb, TilingText& text, const std::string& usual_length) {
    verb.add_option(
        "--edge-length", text.edge_length,
        "Wanted mean length of the sides of the tiles, such as 26mm (default: " + usual_length + ")");
    verb.add_option("--angle", text.angle,
                    "Angle between the rows of tiles and the x axis, such as 15deg (default: the angle that "
                    "gives the most regular tiles)");
    verb.add_option("--narrow", text.narrow,
                    "What to do where the outline is narrower than a tile. refine: make the tiles smaller "
                    "until they fit. merge: as refine, then join small tiles into longer ones where "
                    "possible. refuse: end with an error")
        ->check(CLI::IsMember(kNarrow))
        ->capture_default_str();
}

std::optional<double> wanted_edge_length(const TilingText& text) {
    if (!text.edge_length) return std::nullopt;
    return read_length(kEdgeLength, *text.edge_length);
}

std::optional<double> wanted_angle(const TilingText& text) {
    if (!text.angle) return std::nullopt;
    return base::located("--angle", "", [&] { return base::parse_angle(*text.angle); });
}

tiling::Narrow wanted_narrow(const TilingText& text) {
    return kNarrow.at(text.narrow);
}

}  // namespace fretwork::app

// SPDX-License-Identifier: GPL-3.0-or-later
// DXF files read again.
#pragma once

#include <fretwork/base/text.hpp>
#include <fretwork/fabrication/contour.hpp>

#include <string>
#include <vector>

namespace fretwork::exports::test {

/// A group of a DXF.
struct Group {
    int code;
    std::string value;
};
inline std::vector<Group> groups(const std::string& text) {
    std::vector<Group> list;
    const auto lines = base::split(text, '\n');
    for (std::size_t i = 0; i + 1 < lines.size(); i += 2) list.push_back({std::stoi(lines[i]), lines[i + 1]});
    return list;
}

/// The LWPOLYLINE entities of a layer, in millimetres.
inline std::vector<fabrication::Contour> polylines(const std::string& text, const std::string& layer) {
    std::vector<fabrication::Contour> found;
    std::string entity;
    std::string own_layer;
    fabrication::Contour contour;
    const auto finish = [&] {
        if (entity == "LWPOLYLINE" && own_layer == layer) found.push_back(contour);
        contour.clear();
    };
    for (const auto& [code, value] : groups(text)) {
        if (code == 0) {
            finish();
            entity = value;
        }
        if (entity != "LWPOLYLINE") continue;
        if (code == 8) own_layer = value;
        if (code == 10) contour.push_back({{std::stod(value), 0.0}, 0.0});
        if (code == 20) contour.back().place.y = std::stod(value);
        if (code == 42) contour.back().bulge = std::stod(value);
    }
    return found;
}

}  // namespace fretwork::exports::test

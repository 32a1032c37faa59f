// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/node_layout.hpp>

#include <string>
#include <vector>

namespace fretwork::pattern {

/// Layouts small enough to walk all their graphs, each with something that the paper's has not.
inline std::vector<NodeLayout> small_layouts() {
    const auto r = [](const char* text) { return parse_rational(text); };
    std::vector<NodeLayout> layouts;
    layouts.push_back(find_node_layout("paper7"));
    layouts.emplace_back(NodeLayoutDescription{
        "hollow", false, false, {r("1/3"), r("2/3")}, {{r("3/10"), r("9/20"), r("1/4")}}, {r("1/2")}});
    layouts.emplace_back(
        NodeLayoutDescription{"twin-interface", true, false, {r("1/2")}, {}, {r("1/3"), r("2/3")}});
    layouts.emplace_back(NodeLayoutDescription{
        "hollow-twin", false, false, {r("1/2")}, {{r("2/5"), r("3/10"), r("3/10")}}, {r("1/4"), r("3/4")}});
    layouts.emplace_back(NodeLayoutDescription{
        "three-faces",
        true,
        false,
        {},
        {{r("1/2"), r("1/3"), r("1/6")}, {r("1/2"), r("1/6"), r("1/3")}, {r("1/5"), r("2/5"), r("2/5")}},
        {r("1/2")}});
    return layouts;
}

}  // namespace fretwork::pattern

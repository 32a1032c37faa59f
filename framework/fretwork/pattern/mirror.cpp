// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/mirror.hpp>

#include <algorithm>

namespace fretwork::pattern {
namespace {

std::optional<LayoutNodeIndex> twin_of(const NodeLayout& layout, LayoutNodeIndex node) {
    const auto& place = layout.nodes()[node].place;
    const std::array<Rational, 3> reflected{place[0], place[2], place[1]};
    const auto& nodes = layout.nodes();
    const auto twin = std::find_if(nodes.begin(), nodes.end(),
                                   [&](const LayoutNode& other) { return other.place == reflected; });
    if (twin == nodes.end()) return std::nullopt;
    return LayoutNodeIndex(twin - nodes.begin());
}

/// If an edge lies on the right radial side, where it is not a candidate, move it to the left side. The fan
/// stays the same.
Edge moved_to_left_side(const NodeLayout& layout, const Edge& edge) {
    const auto is_on_right_side = [&](LayoutNodeIndex node) {
        return layout.nodes()[node].place[1] == Rational(0);
    };
    if (!is_on_right_side(edge.first) || !is_on_right_side(edge.second)) return edge;
    return {layout.left_partner(edge.first), layout.left_partner(edge.second)};
}

std::optional<EdgeIndex> edge_image(const NodeLayout& layout, const Edge& edge) {
    const auto first = twin_of(layout, edge.first);
    const auto second = twin_of(layout, edge.second);
    if (!first || !second) return std::nullopt;
    const Edge image = moved_to_left_side(layout, {std::min(*first, *second), std::max(*first, *second)});
    const auto& candidates = layout.candidate_edges();
    const auto found = std::lower_bound(candidates.begin(), candidates.end(), image);
    // The image is not a candidate if a face node lies on it. The edge itself is a candidate all the same,
    // because the layout need not be symmetric.
    if (found == candidates.end() || *found != image) return std::nullopt;
    return EdgeIndex(found - candidates.begin());
}

}  // namespace

Mirror::Mirror(const NodeLayout& layout) {
    for (const Edge& edge : layout.candidate_edges()) images_.push_back(edge_image(layout, edge));
}

std::optional<Pattern> Mirror::image(const Pattern& pattern) const {
    Pattern::Bits bits;
    for (const EdgeIndex edge : pattern.edges()) {
        const std::optional<EdgeIndex> twin = image(edge);
        if (!twin) return std::nullopt;
        bits.set(*twin);
    }
    return Pattern(bits);
}

bool Mirror::is_symmetric(const Pattern& pattern) const {
    return image(pattern) == pattern;
}

}  // namespace fretwork::pattern

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/disjoint_sets.hpp>
#include <fretwork/fabrication/detail/assembling.hpp>
#include <fretwork/fabrication/detail/planar_faces.hpp>
#include <fretwork/geometry/plane.hpp>

#include <limits>
#include <optional>

namespace fretwork::fabrication::detail {
namespace {

using geometry::Point2;

/// Half-bar 2 b is bar b in its own direction, and half-bar 2 b + 1 is bar b reversed.
class HalfBars {
  public:
    explicit HalfBars(const BarPlan& plan) : plan_(plan), leaving_(plan.nodes.size()) {
        for (std::size_t h = 0; h < 2 * plan.bars.size(); ++h) leaving_[start(h)].push_back(h);
        for (auto& around : leaving_)
            std::sort(around.begin(), around.end(),
                      [&](std::size_t a, std::size_t b) { return angle(a) < angle(b); });
        place_.resize(2 * plan.bars.size());
        for (const auto& around : leaving_)
            for (std::size_t i = 0; i < around.size(); ++i) place_[around[i]] = i;
    }

    [[nodiscard]] std::size_t count() const { return place_.size(); }
    [[nodiscard]] std::size_t start(std::size_t half) const { return plan_.bars[half / 2].nodes[half % 2]; }
    [[nodiscard]] const Point2& place(std::size_t half) const { return plan_.nodes[start(half)]; }
    /// The half-bar that continues the walk along the region: the next clockwise from the opposite half-bar.
    [[nodiscard]] std::size_t next(std::size_t half) const {
        const std::size_t back = half ^ 1U;
        const auto& around = leaving_[start(back)];
        return around[(place_[back] + around.size() - 1) % around.size()];
    }

  private:
    [[nodiscard]] double angle(std::size_t half) const {
        const Point2 along = place(half ^ 1U) - place(half);
        return std::atan2(along.y, along.x);
    }

    const BarPlan& plan_;
    std::vector<std::vector<std::size_t>> leaving_;
    std::vector<std::size_t> place_;
};

struct FoundWalk {
    Walk walk;
    double area = 0.0;
    std::size_t component = 0;
};

std::vector<FoundWalk> all_walks(const BarPlan& plan) {
    const HalfBars halves(plan);
    base::DisjointSets components(plan.nodes.size());
    for (const Bar& bar : plan.bars) components.unite(bar.nodes[0], bar.nodes[1]);
    std::vector<bool> seen(halves.count());
    std::vector<FoundWalk> walks;
    for (std::size_t first = 0; first < halves.count(); ++first) {
        if (seen[first]) continue;
        FoundWalk& found = walks.emplace_back();
        found.component = components.first_of(halves.start(first));
        for (std::size_t half = first; !seen[half]; half = halves.next(half)) {
            seen[half] = true;
            found.walk.push_back(halves.place(half));
        }
        found.area = geometry::signed_area(found.walk);
    }
    return walks;
}

/// For each component, the index of the walk around its outside. This walk has the smallest area: negative,
/// or zero for a tree.
std::vector<std::size_t> outside_walks(const std::vector<FoundWalk>& walks, std::size_t nodes) {
    constexpr auto kNone = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> outside(nodes, kNone);
    for (std::size_t w = 0; w < walks.size(); ++w) {
        std::size_t& chosen = outside[walks[w].component];
        if (chosen == kNone || walks[w].area < walks[chosen].area) chosen = w;
    }
    std::erase(outside, kNone);
    return outside;
}

}  // namespace

std::vector<Face> planar_faces(const BarPlan& plan) {
    const auto walks = all_walks(plan);
    const auto outside = outside_walks(walks, plan.nodes.size());
    std::vector<Face> faces;
    std::vector<const FoundWalk*> of_face;
    for (std::size_t w = 0; w < walks.size(); ++w) {
        if (std::find(outside.begin(), outside.end(), w) != outside.end()) continue;
        faces.push_back({walks[w].walk, {}});
        of_face.push_back(&walks[w]);
    }
    faces.emplace_back();
    for (const std::size_t w : outside) {
        std::size_t home = faces.size() - 1;
        for (std::size_t f = 0; outside.size() > 1 && f < of_face.size(); ++f) {
            if (of_face[f]->component == walks[w].component) continue;
            if (!contains(of_face[f]->walk, walks[w].walk.front())) continue;
            if (home == faces.size() - 1 || of_face[f]->area < of_face[home]->area) home = f;
        }
        faces[home].islands.push_back(walks[w].walk);
    }
    return faces;
}

}  // namespace fretwork::fabrication::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/reduction/scenarios/joints.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fretwork::reduction {
namespace {

using std::numbers::pi;

/// The angle (rad) below which two bars count as one, such as a bar along a side and its own image.
constexpr double kSameDirection = 1e-6;

/// A bar as it leaves a node.
struct Departure {
    double angle = 0.0;  ///< direction, rad, within [-pi, pi]
    /// The sum to which the reach of the bar is added; null for a bar beyond the polygon's side.
    double* reach = nullptr;
};
using Joint = std::vector<Departure>;

/// The distance, in widths, from a node to the place where the outlines of two bars separate.
double parting(double angle) {
    return angle < pi ? 0.5 / std::tan(angle / 2.0) : 0.0;
}

/// The angle from each bar to the next one, counterclockwise.
std::vector<double> gaps_of(const Joint& joint) {
    std::vector<double> gaps;
    for (std::size_t i = 0; i < joint.size(); ++i) {
        const bool is_last = i + 1 == joint.size();
        gaps.push_back(is_last ? joint.front().angle + 2.0 * pi - joint[i].angle
                               : joint[i + 1].angle - joint[i].angle);
    }
    return gaps;
}

void add_reaches(Joint joint) {
    std::ranges::sort(joint, {}, &Departure::angle);
    const std::vector<double> gaps = gaps_of(joint);
    for (std::size_t i = 0; i < joint.size(); ++i) {
        if (joint[i].reach == nullptr) continue;
        const double before = gaps[i == 0 ? gaps.size() - 1 : i - 1];
        *joint[i].reach += std::max(parting(before), parting(gaps[i]));
    }
}

double angle_between(const geometry::Point2& from, const geometry::Point2& to) {
    return std::atan2(to.y - from.y, to.x - from.x);
}

bool leaves_towards(const Joint& joint, double angle) {
    return std::ranges::any_of(joint, [&](const Departure& departure) {
        return std::abs(std::remainder(departure.angle - angle, 2.0 * pi)) < kSameDirection;
    });
}

/// The joints of the tile, without bars beyond its sides.
std::vector<Joint> joints_of(const pattern::Fan& fan, std::span<const geometry::Point2> places,
                             std::vector<double>& reaches) {
    std::vector<Joint> joints(fan.nodes.size());
    for (std::size_t i = 0; i < fan.edges.size(); ++i) {
        const std::size_t first = fan.edges[i][0];
        const std::size_t second = fan.edges[i][1];
        joints[first].push_back({angle_between(places[first], places[second]), &reaches[i]});
        joints[second].push_back({angle_between(places[second], places[first]), &reaches[i]});
    }
    return joints;
}

/// The interface node on which another interface node falls if their side is turned by half a turn.
std::size_t opposite_on_side(const pattern::Fan& fan, std::size_t node) {
    const std::size_t a_side = fan.interface_node_count / fan.sides;
    return node - node % a_side + (a_side - 1 - node % a_side);
}

/// A joint on the polygon's side, with the bars beyond it.
Joint with_bars_beyond(Joint own, const Joint& opposite) {
    const Joint alone = own;
    for (const Departure& departure : opposite) {
        const double angle = std::remainder(departure.angle + pi, 2.0 * pi);
        if (!leaves_towards(alone, angle)) own.push_back({angle, nullptr});
    }
    return own;
}

}  // namespace

std::vector<double> joint_reaches(const pattern::Fan& fan, std::span<const geometry::Point2> places) {
    std::vector<double> reaches(fan.edges.size(), 0.0);
    const std::vector<Joint> joints = joints_of(fan, places, reaches);
    const std::size_t interface_nodes = fan.interface_node_count;
    for (std::size_t node = 0; node < joints.size(); ++node) {
        if (joints[node].empty()) continue;
        add_reaches(node < interface_nodes
                        ? with_bars_beyond(joints[node], joints[opposite_on_side(fan, node)])
                        : joints[node]);
    }
    return reaches;
}

TileMaterial bar_of(const Setting& setting, const BarPlace& place) {
    TileMaterial bar{setting.section, setting.material};
    if (setting.joints == Joints::Centreline) return bar;
    const double width = mechanics::rectangle_width(bar.section);
    const double elastic =
        std::max(1.0 - kStiffShare * place.joint_reach * width / place.length, kLeastElasticShare);
    bar.section.area /= elastic;
    bar.section.J /= elastic;
    bar.section.I3 /= elastic * elastic * elastic;
    if (bar.section.shear_area2) *bar.section.shear_area2 /= elastic;
    bar.material.density *= elastic;
    return bar;
}

}  // namespace fretwork::reduction

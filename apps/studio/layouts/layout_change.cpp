// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <studio/layouts/layout_change.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace fretwork::studio {
namespace {

using pattern::LayoutNodeIndex;
using pattern::NodeLayout;
using pattern::NodeLayoutDescription;
using pattern::Rational;
using pattern::Region;
using HandPlace = LayoutChange::Place;
using ExactPlace = std::array<Rational, 3>;

const Rational kMiddle(1, 2);

/// The number of a node among those of its region.
std::size_t number_in_region(const NodeLayout& layout, LayoutNodeIndex node) {
    const auto first = layout.nodes().begin();
    return static_cast<std::size_t>(std::count_if(first, first + node.value, [&](const auto& other) {
        return other.region == layout.nodes()[node].region;
    }));
}

LayoutNodeIndex node_of(const NodeLayout& layout, Region region, std::size_t number) {
    for (std::size_t i = 0; i < layout.nodes().size(); ++i) {
        if (layout.nodes()[i].region == region && number-- == 0) return LayoutNodeIndex(i);
    }
    throw base::InputError("there is no such node");
}

ExactPlace mirrored(const ExactPlace& place) {
    return {place[0], place[2], place[1]};
}

std::optional<std::size_t> face_at(const NodeLayoutDescription& description, const ExactPlace& place) {
    const auto found = std::ranges::find(description.face, place);
    if (found == description.face.end()) return std::nullopt;
    return static_cast<std::size_t>(found - description.face.begin());
}

// ---- places on the grid ----

/// The share along a side of the regular triangle at which the perpendicular through a place meets it.
double share_of(const HandPlace& place, Region region) {
    switch (region) {
        case Region::LeftRadial:
            return place[1] + 0.5 * place[2];
        case Region::RightRadial:
            return place[2] + 0.5 * place[1];
        default:
            return place[2] + 0.5 * place[0];
    }
}

/// An open interval of shares.
struct Between {
    Rational low{0};
    Rational high{1};
};

/// The place of the grid in an open interval that is nearest to a share; none if the grid has none there.
std::optional<Rational> on_grid(double share, const Between& bounds, std::int64_t steps) {
    const Rational low = bounds.low * Rational(steps);
    const Rational high = bounds.high * Rational(steps);
    const std::int64_t first = low.numerator() / low.denominator() + 1;
    const std::int64_t last = (high.numerator() + high.denominator() - 1) / high.denominator() - 1;
    if (first > last) return std::nullopt;
    const double wanted = std::round(share * static_cast<double>(steps));
    const double nearest = std::clamp(wanted, static_cast<double>(first), static_cast<double>(last));
    return Rational(static_cast<std::int64_t>(nearest), steps);
}

ExactPlace face_place(std::int64_t first, std::int64_t second, std::int64_t steps) {
    return {Rational(steps - first - second, steps), Rational(first, steps), Rational(second, steps)};
}

/// The place of the grid inside of the triangle that is near to a place.
ExactPlace face_on_grid(const HandPlace& place, std::int64_t steps) {
    const auto nearest = [steps](double share, std::int64_t most) {
        return static_cast<std::int64_t>(
            std::clamp(std::round(share * static_cast<double>(steps)), 1.0, static_cast<double>(most)));
    };
    const std::int64_t first = nearest(place[1], steps - 2);
    return face_place(first, nearest(place[2], steps - 1 - first), steps);
}

ExactPlace axis_on_grid(const HandPlace& place, std::int64_t steps) {
    const double half = std::round(0.5 * (place[1] + place[2]) * static_cast<double>(steps));
    const std::int64_t most = (steps - 1) / 2;
    const auto both = static_cast<std::int64_t>(std::clamp(half, 1.0, static_cast<double>(most)));
    return face_place(both, both, steps);
}

// ---- moving ----

Between neighbours_of(const std::vector<Rational>& shares, std::size_t number) {
    Between bounds;
    if (number > 0) bounds.low = shares[number - 1];
    if (number + 1 < shares.size()) bounds.high = shares[number + 1];
    return bounds;
}

void move_radial(NodeLayoutDescription& description, std::size_t number, double share,
                 const LayoutHand& hand) {
    const auto place = on_grid(share, neighbours_of(description.radial, number), hand.steps);
    if (place) description.radial[number] = *place;
}

/// A node and its twin move as mirror images. A node in the middle is its own twin, and stays.
void move_interface(NodeLayoutDescription& description, std::size_t number, double share,
                    const LayoutHand& hand) {
    std::vector<Rational>& shares = description.interface;
    const std::size_t twin = shares.size() - 1 - number;
    if (number == twin) return;
    const std::size_t lower = std::min(number, twin);
    Between bounds = neighbours_of(shares, lower);
    bounds.high = std::min(bounds.high, kMiddle);
    const auto place = on_grid(number == lower ? share : 1.0 - share, bounds, hand.steps);
    if (!place) return;
    shares[lower] = *place;
    shares[shares.size() - 1 - lower] = Rational(1) - *place;
}

void move_face(NodeLayoutDescription& description, std::size_t number, const HandPlace& to,
               const LayoutHand& hand) {
    const ExactPlace before = description.face[number];
    const ExactPlace image = mirrored(before);
    if (hand.keeps_mirror && before == image) {
        description.face[number] = axis_on_grid(to, hand.steps);
        return;
    }
    const ExactPlace next = face_on_grid(to, hand.steps);
    const auto twin = face_at(description, image);
    description.face[number] = next;
    if (hand.keeps_mirror && twin) description.face[*twin] = mirrored(next);
}

ChangedLayout moved(const NodeLayout& layout, const LayoutChange& change, const LayoutHand& hand) {
    NodeLayoutDescription next = layout.description();
    const Region region = layout.nodes()[change.node].region;
    const std::size_t number = number_in_region(layout, change.node);
    const HandPlace to = change.to.value();
    if (region == Region::LeftRadial || region == Region::RightRadial)
        move_radial(next, number, share_of(to, region), hand);
    if (region == Region::Interface) move_interface(next, number, share_of(to, region), hand);
    if (region == Region::Face) move_face(next, number, to, hand);
    return {NodeLayout(std::move(next)), change.node};
}

// ---- adding ----

/// The middle of the largest gap between shares and the ends of an interval.
double middle_of_gap(std::vector<Rational> shares, const Between& ends) {
    shares.insert(shares.begin(), ends.low);
    shares.push_back(ends.high);
    std::size_t widest = 1;
    for (std::size_t i = 2; i < shares.size(); ++i) {
        if (shares[i] - shares[i - 1] > shares[widest] - shares[widest - 1]) widest = i;
    }
    return 0.5 * (shares[widest - 1] + shares[widest]).to_double();
}

/// @return  the number of the share in the list
std::size_t insert_share(std::vector<Rational>& shares, const Rational& share) {
    const auto place = std::ranges::lower_bound(shares, share);
    const auto number = place - shares.begin();
    shares.insert(place, share);
    return static_cast<std::size_t>(number);
}

Rational grid_share(double share, const LayoutHand& hand) {
    return on_grid(share, {}, hand.steps).value();
}

ChangedLayout with_radial(NodeLayoutDescription next, const LayoutChange& change, const LayoutHand& hand) {
    const auto side = [](const HandPlace& to) {
        return to[1] >= to[2] ? share_of(to, Region::LeftRadial) : share_of(to, Region::RightRadial);
    };
    const double share = change.to ? side(*change.to) : middle_of_gap(next.radial, {});
    const std::size_t number = insert_share(next.radial, grid_share(share, hand));
    NodeLayout layout(std::move(next));
    const LayoutNodeIndex node = node_of(layout, Region::LeftRadial, number);
    return {std::move(layout), node};
}

ChangedLayout with_interface(NodeLayoutDescription next, const LayoutChange& change, const LayoutHand& hand) {
    std::vector<Rational>& shares = next.interface;
    std::vector<Rational> lower;
    std::ranges::copy_if(shares, std::back_inserter(lower),
                         [](const Rational& share) { return share <= kMiddle; });
    const double wanted =
        change.to ? share_of(*change.to, Region::Interface) : middle_of_gap(lower, {Rational(0), kMiddle});
    const Rational share = grid_share(wanted, hand);
    if (share != kMiddle) insert_share(shares, Rational(1) - share);
    const std::size_t number = insert_share(shares, share);  // last: inserting the twin may shift it
    NodeLayout layout(std::move(next));
    const LayoutNodeIndex node = node_of(layout, Region::Interface, number);
    return {std::move(layout), node};
}

double squared_distance(const HandPlace& one, const HandPlace& other) {
    // In a regular triangle with sides of length one.
    const std::array<double, 3> d{one[0] - other[0], one[1] - other[1], one[2] - other[2]};
    return 0.5 * (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
}

HandPlace to_doubles(const ExactPlace& place) {
    return {place[0].to_double(), place[1].to_double(), place[2].to_double()};
}

/// The place inside of the triangle that is farthest from all nodes and from the sides. Places on a grid with
/// steps of about a 24th of a side are tried.
ExactPlace most_room(const NodeLayout& layout, const LayoutHand& hand) {
    constexpr std::int64_t kTried = 24;
    const std::int64_t stride = std::max<std::int64_t>(1, hand.steps / kTried);
    ExactPlace best = face_place(1, 1, hand.steps);
    double most = -1.0;
    for (std::int64_t first = stride; first < hand.steps; first += stride) {
        for (std::int64_t second = stride; first + second < hand.steps; second += stride) {
            const ExactPlace exact = face_place(first, second, hand.steps);
            const HandPlace place = to_doubles(exact);
            // The height over a side is the coordinate times the triangle's height, whose square is 3/4.
            double room = 0.75 * std::pow(std::min({place[0], place[1], place[2]}), 2);
            for (const auto& node : layout.nodes())
                room = std::min(room, squared_distance(place, to_doubles(node.place)));
            if (room > most) std::tie(best, most) = std::pair(exact, room);
        }
    }
    return best;
}

ChangedLayout with_face(const NodeLayout& before, const LayoutChange& change, const LayoutHand& hand) {
    NodeLayoutDescription next = before.description();
    const ExactPlace place = change.to ? face_on_grid(*change.to, hand.steps) : most_room(before, hand);
    const std::size_t number = next.face.size();
    next.face.push_back(place);
    if (hand.keeps_mirror && !face_at(next, mirrored(place))) next.face.push_back(mirrored(place));
    NodeLayout layout(std::move(next));
    const LayoutNodeIndex node = node_of(layout, Region::Face, number);
    return {std::move(layout), node};
}

ChangedLayout with_center(NodeLayoutDescription next) {
    if (next.center) throw base::InputError("there is a center node already");
    next.center = true;
    return {NodeLayout(std::move(next)), LayoutNodeIndex(0)};
}

ChangedLayout with_node(const NodeLayout& layout, const LayoutChange& change, const LayoutHand& hand) {
    switch (change.region) {
        case Region::Center:
            return with_center(layout.description());
        case Region::Face:
            return with_face(layout, change, hand);
        case Region::Interface:
            return with_interface(layout.description(), change, hand);
        default:
            return with_radial(layout.description(), change, hand);
    }
}

// ---- removing ----

ChangedLayout without_node(const NodeLayout& layout, const LayoutChange& change, const LayoutHand& hand) {
    NodeLayoutDescription next = layout.description();
    const auto number = static_cast<std::ptrdiff_t>(number_in_region(layout, change.node));
    const auto& [region, place] = layout.nodes()[change.node];
    if (region == Region::Center) next.center = false;
    if (region == Region::LeftRadial || region == Region::RightRadial)
        next.radial.erase(next.radial.begin() + number);
    if (region == Region::Face)
        std::erase_if(next.face, [&, &exact = place](const ExactPlace& other) {
            return other == exact || (hand.keeps_mirror && other == mirrored(exact));
        });
    if (region == Region::Interface)
        std::erase_if(next.interface, [share = place[2]](const Rational& other) {
            return other == share || other == Rational(1) - share;
        });
    return {NodeLayout(std::move(next))};
}

}  // namespace

std::vector<LayoutNodeIndex> twins_of(const NodeLayout& layout, LayoutNodeIndex node) {
    const auto& [region, place] = layout.nodes()[node];
    std::vector<LayoutNodeIndex> twins;
    for (std::size_t i = 0; i < layout.nodes().size(); ++i) {
        // The mirror image of a radial node is its partner, and that of an interface node its twin.
        if (LayoutNodeIndex(i) != node && layout.nodes()[i].place == mirrored(place)) twins.emplace_back(i);
    }
    return twins;
}

ChangedLayout changed(const NodeLayout& layout, const LayoutChange& change, const LayoutHand& hand) {
    switch (change.kind) {
        case LayoutChange::Kind::Add:
            return with_node(layout, change, hand);
        case LayoutChange::Kind::Remove:
            return without_node(layout, change, hand);
        case LayoutChange::Kind::Move:
            break;
    }
    return moved(layout, change, hand);
}

}  // namespace fretwork::studio

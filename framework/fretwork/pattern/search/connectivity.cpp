// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/fan.hpp>
#include <fretwork/pattern/search/connectivity.hpp>

#include <bit>
#include <numeric>

namespace fretwork::pattern::detail {
namespace {

using Orbits = std::uint64_t;

Orbits lowest(Orbits orbits) {
    return orbits & (~orbits + 1);
}

bool contains(Orbits orbits, int orbit) {
    return (orbits >> orbit & 1) != 0;
}

/// For a part of the quotient: the sector of each orbit's node on a lifted spanning tree, and the cycle gain.
struct Potentials {
    std::array<int, 64> sector{};
    int cycle_gain = 0;  ///< greatest common divisor of all cycle gains and the number of sectors
};

Potentials potentials(std::span<const Quotient::Link> links, Orbits part) {
    Potentials result;
    Orbits known = lowest(part);
    result.sector[std::countr_zero(part)] = 0;
    for (Orbits before = 0; before != known;) {
        before = known;
        for (const auto& [first, second, gain] : links) {
            if (!contains(part, first) || !contains(part, second)) continue;
            if (contains(known, first) && !contains(known, second))
                result.sector[second] = result.sector[first] + gain;
            if (contains(known, second) && !contains(known, first))
                result.sector[first] = result.sector[second] - gain;
            if (contains(known, first) || contains(known, second))
                known |= Orbits{1} << first | Orbits{1} << second;
        }
    }
    result.cycle_gain = kReferenceSides;
    for (const auto& [first, second, gain] : links) {
        if (!contains(part, first) || !contains(part, second)) continue;
        const int around = result.sector[first] + gain - result.sector[second];
        result.cycle_gain = std::gcd(result.cycle_gain, around);
    }
    return result;
}

}  // namespace

/// All orbits that can be reached from the seeds.
Orbits Connectivity::flood(Orbits seeds, Orbits within) const {
    Orbits reached = seeds & within;
    for (Orbits front = reached; front != 0;) {
        const int orbit = std::countr_zero(front);
        const Orbits fresh = neighbours_[orbit] & within & ~reached;
        reached |= fresh;
        front = (front & (front - 1)) | fresh;
    }
    return reached;
}

/// All orbits that can be reached from the seeds if the outside connects all interface nodes.
Orbits Connectivity::flood_with_outside(Orbits seeds, Orbits within) const {
    const Orbits reached = flood(seeds, within);
    const Orbits interface = quotient_->interface_orbits();
    return (reached & interface) != 0 ? flood(reached | interface, within) : reached;
}

/// The number of components of the fan, without the outside, to which a connected part of the quotient lifts.
int Connectivity::lifted_components(Orbits part) const {
    if ((part & center_bit()) != 0) return 1;
    return potentials(std::span(links_).first(link_count_), part).cycle_gain;
}

bool Connectivity::is_connected() const {
    if (used_ == 0) return true;
    return flood(lowest(used_), used_) == used_ && lifted_components(used_) == 1;
}

bool Connectivity::has_articulation() const {
    for (Orbits rest = used_; rest != 0;) {
        const Orbits component = flood_with_outside(lowest(rest), used_);
        rest &= ~component;
        for (Orbits nodes = component; nodes != 0; nodes &= nodes - 1) {
            const int orbit = std::countr_zero(nodes);
            const bool is_center = orbit == quotient_->center();
            if (is_center ? center_is_articulation(component) : orbit_is_articulation(orbit, component))
                return true;
        }
    }
    return false;
}

bool Connectivity::center_is_articulation(Orbits component) const {
    Orbits rest = component & ~center_bit();
    const Orbits interface = quotient_->interface_orbits();
    int components = 0;
    while (rest != 0) {
        const Orbits part = flood_with_outside(lowest(rest), rest);
        components += (part & interface) != 0 ? 1 : lifted_components(part);
        rest &= ~part;
    }
    return components > 1;
}

bool Connectivity::orbit_is_articulation(int orbit, Orbits component) const {
    const Orbits others = component & ~(Orbits{1} << orbit);
    Orbits rest = others & ~flood(roots(), others);
    if (rest == 0) return false;
    const bool has_root = (component & roots()) != 0;
    const bool several_copies = has_root || lifted_components(component) < kReferenceSides;
    while (rest != 0) {
        const Orbits part = flood(lowest(rest), rest);
        const bool leaves_something = several_copies || part != others;
        if (leaves_something && hangs_on_one_copy(part, orbit)) return true;
        rest &= ~part;
    }
    return false;
}

/// True if each lifted component of a part without roots has links to a single copy of the orbit.
bool Connectivity::hangs_on_one_copy(Orbits part, int orbit) const {
    const std::span<const Quotient::Link> links = std::span(links_).first(link_count_);
    const Potentials inside = potentials(links, part);
    if (inside.cycle_gain != kReferenceSides) return false;
    int copies = 0;  // one bit for each sector
    for (const auto& [first, second, gain] : links) {
        const bool starts_inside = contains(part, first) && second == orbit;
        const bool ends_inside = contains(part, second) && first == orbit;
        if (!starts_inside && !ends_inside) continue;
        const int sector = starts_inside ? inside.sector[first] + gain : inside.sector[second] - gain;
        copies |= 1 << ((sector % kReferenceSides + kReferenceSides) % kReferenceSides);
    }
    return std::has_single_bit(static_cast<unsigned>(copies));
}

}  // namespace fretwork::pattern::detail

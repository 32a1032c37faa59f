// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/detail/layout_rules.hpp>

#include <algorithm>

namespace fretwork::pattern::detail {
namespace {

using Fault = std::optional<LayoutFault>;
using Place = std::array<Rational, 3>;

/// The largest denominator with which every sum of three coordinates stays within 64 bits.
constexpr std::int64_t kLargestDenominator = 1'000'000;

/// The largest number of nodes whose sets fit into a machine word.
constexpr std::size_t kMostNodes = 64;

std::string indexed(const char* key, std::size_t i) {
    return "/" + std::string(key) + "/" + std::to_string(i);
}

std::string node_name(std::size_t number) {
    return "node n" + std::to_string(number);
}

/// Check shares along a side: they lie strictly between the ends of the side, and ascend.
Fault check_shares(const std::vector<Rational>& shares, const char* key, std::size_t first_number) {
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const std::string subject = node_name(first_number + i) + " at " + shares[i].text() + " ";
        if (shares[i].denominator() > kLargestDenominator)
            return LayoutFault{indexed(key, i), subject + "needs a denominator of at most 1000000"};
        if (shares[i] <= Rational(0) || shares[i] >= Rational(1))
            return LayoutFault{indexed(key, i),
                               subject + "must lie strictly between 0 and 1, the ends of its side"};
        if (i > 0 && shares[i] <= shares[i - 1])
            return LayoutFault{indexed(key, i), subject + "must come after the one at " +
                                                    shares[i - 1].text() +
                                                    ": shares ascend, and no two nodes coincide"};
    }
    return std::nullopt;
}

Fault check_symmetry(const std::vector<Rational>& shares, std::size_t first_number) {
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const Rational twin = Rational(1) - shares[i];
        if (std::find(shares.begin(), shares.end(), twin) == shares.end())
            return LayoutFault{indexed("interface", i),
                               node_name(first_number + i) + " at " + shares[i].text() + " has no twin at " +
                                   twin.text() +
                                   ": interface nodes lie symmetrically about the middle of their side, or "
                                   "neighbouring tiles would not meet"};
    }
    return std::nullopt;
}

Fault check_face_node(const Place& place, const std::string& pointer, const std::string& subject) {
    for (const Rational& coordinate : place) {
        if (coordinate.denominator() > kLargestDenominator)
            return LayoutFault{pointer, subject + "needs denominators of at most 1000000"};
        if (coordinate <= Rational(0) || coordinate >= Rational(1))
            return LayoutFault{
                pointer, subject + "must lie strictly inside the base triangle, but has the coordinate " +
                             coordinate.text() +
                             "; nodes on its sides are listed in 'radial' and 'interface'"};
    }
    const Rational sum = place[0] + place[1] + place[2];
    if (sum != Rational(1))
        return LayoutFault{pointer,
                           subject + "has barycentric coordinates with sum " + sum.text() + " instead of 1"};
    return std::nullopt;
}

Fault check_face(const std::vector<Place>& face, std::size_t first_number) {
    for (std::size_t i = 0; i < face.size(); ++i) {
        const std::string subject = node_name(first_number + i) + " (face) ";
        if (Fault fault = check_face_node(face[i], indexed("face", i), subject)) return fault;
        const auto twin = std::find(face.begin(), face.begin() + i, face[i]);
        if (twin != face.begin() + i)
            return LayoutFault{
                indexed("face", i),
                subject + "lies where " + node_name(first_number + (twin - face.begin())) + " already is"};
    }
    return std::nullopt;
}

Fault check_name(const std::string& name) {
    const auto is_allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
               c == '_';
    };
    if (!name.empty() && std::all_of(name.begin(), name.end(), is_allowed)) return std::nullopt;
    return LayoutFault{"/name",
                       "'" + name + "' is not a name of a layout: expected letters, digits, '-' and '_'"};
}

}  // namespace

std::optional<LayoutFault> find_layout_fault(const NodeLayoutDescription& description) {
    const std::size_t first_radial = description.center ? 1 : 0;
    const std::size_t first_face = first_radial + 2 * description.radial.size();
    const std::size_t first_interface = first_face + description.face.size();
    if (first_interface + description.interface.size() > kMostNodes)
        return LayoutFault{"", "there are more than " + std::to_string(kMostNodes) + " nodes"};
    if (Fault fault = check_name(description.name)) return fault;
    if (description.corners)
        return LayoutFault{
            "/corners",
            "nodes at the corners v1 and v2 are not supported yet: every polygon that meets at a "
            "corner would share them"};
    if (Fault fault = check_shares(description.radial, "radial", first_radial)) return fault;
    if (Fault fault = check_face(description.face, first_face)) return fault;
    if (description.interface.empty())
        return LayoutFault{"/interface",
                           "there is no interface node, so that no pattern could meet its neighbours"};
    if (Fault fault = check_shares(description.interface, "interface", first_interface)) return fault;
    return check_symmetry(description.interface, first_interface);
}

}  // namespace fretwork::pattern::detail

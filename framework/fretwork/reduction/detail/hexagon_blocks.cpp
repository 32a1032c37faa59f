// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/reduction/detail/hexagon_blocks.hpp>

#include <cmath>
#include <numbers>

namespace fretwork::reduction::detail {
namespace {

using Eigen::Matrix3d;

/// The parameters by name.
struct PlaneRing {
    explicit PlaneRing(const PlaneParameters& p) : link{p[0], p[1]}, ring{p[2], p[3]}, theta(p[4]), R(p[5]) {}
    struct Section {
        double axial;
        double bending;
    };
    Section link;
    Section ring;
    double theta;
    double R;
};
using PlaneSection = PlaneRing::Section;

/// The entries of an Euler-Bernoulli beam's stiffness. The blocks are linear in these entries.
struct BeamEntries {
    double axial;     ///< EA/l or GJ/l
    double shear;     ///< 12 EI/l^3
    double coupling;  ///< 6 EI/l^2
    double near;      ///< 4 EI/l
    double far;       ///< 2 EI/l
};

BeamEntries beam_entries(const PlaneSection& section, double l) {
    const auto [axial, bending] = section;
    return {axial / l, 12.0 * bending / (l * l * l), 6.0 * bending / (l * l), 4.0 * bending / l,
            2.0 * bending / l};
}

BeamEntries beam_entries_by_length(const PlaneSection& section, double l) {
    const auto [axial, bending] = section;
    const double l2 = l * l;
    return {-axial / l2, -36.0 * bending / (l2 * l2), -12.0 * bending / (l2 * l), -4.0 * bending / l2,
            -2.0 * bending / l2};
}

/// The 3 x 3 blocks of a beam between its first and second node.
struct BeamBlocks {
    Matrix3d first;
    Matrix3d across;  ///< first row, second column
    Matrix3d second;
};

/// The blocks in the beam's own axes: (u_along, u_across, r_z), or (u_z, r_along, r_across) with r_across =
/// -du_z/ds.
BeamBlocks own_blocks(Plane plane, const BeamEntries& k) {
    BeamBlocks b;
    if (plane == Plane::InPlane) {
        b.first << k.axial, 0, 0, 0, k.shear, k.coupling, 0, k.coupling, k.near;
        b.across << -k.axial, 0, 0, 0, -k.shear, k.coupling, 0, -k.coupling, k.far;
        b.second << k.axial, 0, 0, 0, k.shear, -k.coupling, 0, -k.coupling, k.near;
    } else {
        b.first << k.shear, 0, -k.coupling, 0, k.axial, 0, -k.coupling, 0, k.near;
        b.across << -k.shear, 0, -k.coupling, 0, -k.axial, 0, k.coupling, 0, k.far;
        b.second << k.shear, 0, k.coupling, 0, k.axial, 0, k.coupling, 0, k.near;
    }
    return b;
}

/// The derivative of turn_to() with respect to the angle.
Matrix3d turn_rate(Plane plane, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    Matrix3d rate = Matrix3d::Zero();
    rate.block<2, 2>(plane == Plane::InPlane ? 0 : 1, plane == Plane::InPlane ? 0 : 1) << -s, c, -c, -s;
    return rate;
}

BeamBlocks turned(const BeamBlocks& own, const Matrix3d& first_turn, const Matrix3d& second_turn) {
    return {first_turn.transpose() * own.first * first_turn,
            first_turn.transpose() * own.across * second_turn,
            second_turn.transpose() * own.second * second_turn};
}

Matrix3d twice_symmetric(const Matrix3d& m) {
    return m + m.transpose();
}

/// A link in the axes of its two nodes.
struct Link {
    double length;
    double first_angle;   ///< direction of the link in the axes of the interface node
    double second_angle;  ///< direction of the link in the axes of the ring node
};

/// The derivatives of a link's quantities.
using LinkRate = Link;

struct LinkGeometry {
    Link link;
    LinkRate by_theta;
    LinkRate by_R;
};

LinkGeometry link_geometry(double theta, double R, double apothem) {
    const double c = std::cos(theta);
    const double s = std::sin(theta);
    const double dx = R * c - apothem;
    const double dy = R * s;
    const double length = std::hypot(dx, dy);
    const double angle = std::atan2(dy, dx);
    // The derivative of (dx, dy) is (-R s, R c) with respect to theta, and (c, s) with respect to R.
    const double angle_by_theta = (dx * R * c + dy * R * s) / (length * length);
    const double angle_by_R = (dx * s - dy * c) / (length * length);
    return {{length, angle, angle - theta},
            {(-dx * R * s + dy * R * c) / length, angle_by_theta, angle_by_theta - 1.0},
            {(dx * c + dy * s) / length, angle_by_R, angle_by_R}};
}

BeamBlocks link_blocks(Plane plane, const BeamEntries& entries, const Link& link) {
    return turned(own_blocks(plane, entries), turn_to(plane, link.first_angle),
                  turn_to(plane, link.second_angle));
}

BeamBlocks link_derivative(Plane plane, const PlaneSection& section, const Link& link, const LinkRate& rate) {
    const BeamBlocks own = own_blocks(plane, beam_entries(section, link.length));
    const BeamBlocks stretched = link_blocks(plane, beam_entries_by_length(section, link.length), link);
    const Matrix3d turn1 = turn_to(plane, link.first_angle);
    const Matrix3d turn2 = turn_to(plane, link.second_angle);
    const Matrix3d rate1 = rate.first_angle * turn_rate(plane, link.first_angle);
    const Matrix3d rate2 = rate.second_angle * turn_rate(plane, link.second_angle);
    return {rate.length * stretched.first + twice_symmetric(rate1.transpose() * own.first * turn1),
            rate.length * stretched.across + rate1.transpose() * own.across * turn2 +
                turn1.transpose() * own.across * rate2,
            rate.length * stretched.second + twice_symmetric(rate2.transpose() * own.second * turn2)};
}

/// The blocks of a ring beam. Its length is R, and its directions in the axes of its nodes never change.
BeamBlocks ring_blocks(Plane plane, const BeamEntries& entries) {
    static const std::array<Matrix3d, 4> kTurns = {turn_to(Plane::InPlane, 2.0 * std::numbers::pi / 3.0),
                                                   turn_to(Plane::InPlane, std::numbers::pi / 3.0),
                                                   turn_to(Plane::OutOfPlane, 2.0 * std::numbers::pi / 3.0),
                                                   turn_to(Plane::OutOfPlane, std::numbers::pi / 3.0)};
    const std::size_t at = plane == Plane::InPlane ? 0 : 2;
    return turned(own_blocks(plane, entries), kTurns[at], kTurns[at + 1]);
}

HexagonBlocks combine(const BeamBlocks& link, const BeamBlocks& ring) {
    return {link.first, link.across, link.second + ring.first + ring.second, ring.across};
}

BeamBlocks no_beam() {
    return {Matrix3d::Zero(), Matrix3d::Zero(), Matrix3d::Zero()};
}

}  // namespace

Matrix3d turn_to(Plane plane, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    Matrix3d turn = Matrix3d::Identity();
    turn.block<2, 2>(plane == Plane::InPlane ? 0 : 1, plane == Plane::InPlane ? 0 : 1) << c, s, -s, c;
    return turn;
}

HexagonBlocks hexagon_blocks(Plane plane, const PlaneParameters& parameters, double apothem) {
    const PlaneRing p(parameters);
    const Link link = link_geometry(p.theta, p.R, apothem).link;
    return combine(link_blocks(plane, beam_entries(p.link, link.length), link),
                   ring_blocks(plane, beam_entries(p.ring, p.R)));
}

std::array<HexagonBlocks, kPlaneParameters> hexagon_block_derivatives(Plane plane,
                                                                      const PlaneParameters& parameters,
                                                                      double apothem) {
    const PlaneRing p(parameters);
    const LinkGeometry geometry = link_geometry(p.theta, p.R, apothem);
    const Link& link = geometry.link;
    const auto by_link = [&](const PlaneSection& section) {
        return combine(link_blocks(plane, beam_entries(section, link.length), link), no_beam());
    };
    const auto by_ring = [&](const PlaneSection& section) {
        return combine(no_beam(), ring_blocks(plane, beam_entries(section, p.R)));
    };
    return {by_link({1.0, 0.0}),
            by_link({0.0, 1.0}),
            by_ring({1.0, 0.0}),
            by_ring({0.0, 1.0}),
            combine(link_derivative(plane, p.link, link, geometry.by_theta), no_beam()),
            combine(link_derivative(plane, p.link, link, geometry.by_R),
                    ring_blocks(plane, beam_entries_by_length(p.ring, p.R)))};
}

HexagonBlocks no_blocks() {
    return {Matrix3d::Zero(), Matrix3d::Zero(), Matrix3d::Zero(), Matrix3d::Zero()};
}

void add_blocks(HexagonBlocks& sum, double factor, const HexagonBlocks& blocks) {
    sum.interface_own += factor * blocks.interface_own;
    sum.interface_ring += factor * blocks.interface_ring;
    sum.ring_own += factor * blocks.ring_own;
    sum.ring_next += factor * blocks.ring_next;
}

double sum_of_products(const HexagonBlocks& one, const HexagonBlocks& other) {
    return one.interface_own.cwiseProduct(other.interface_own).sum() +
           one.interface_ring.cwiseProduct(other.interface_ring).sum() +
           one.ring_own.cwiseProduct(other.ring_own).sum() +
           one.ring_next.cwiseProduct(other.ring_next).sum();
}

}  // namespace fretwork::reduction::detail

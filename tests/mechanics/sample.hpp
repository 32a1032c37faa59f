// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/element.hpp>

#include <cstdint>
#include <numbers>
#include <vector>

namespace fretwork::mechanics::sample {

inline constexpr DofSet kPinned = DofSet::translations();

/// Uniform numbers in [-1, 1), the same on every system.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    double next() {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(state_ >> 11) * 0x1.0p-52 - 1.0;
    }
    Eigen::Vector3d vector(double size) {
        const double x = next();
        const double y = next();
        return size * Eigen::Vector3d(x, y, next());
    }
    Eigen::Quaterniond rotation() { return geometry::exponential(vector(2.5)); }

  private:
    std::uint64_t state_;
};

inline Material plastic() {
    return {.young_modulus = 1e9, .poisson_ratio = 0.3, .density = 1240.0};
}
inline Section bar() {
    return rectangle_section(0.002, 0.002);
}

inline Beam beam_between(int from, int to) {
    return {.nodes = {NodeIndex(from), NodeIndex(to)}, .section = bar(), .material = plastic()};
}

inline void clamp(Frame& frame, int node) {
    frame.supports.push_back({NodeIndex(node), DofSet::all()});
}

/// Clamped at the origin, along x.
struct CantileverShape {
    double length = 1.0;
    int divisions = 1;
    Section section{.area = 0.01, .I2 = 1e-6, .I3 = 2e-6, .J = 2.5e-6};
    Material material{.young_modulus = 1e9, .poisson_ratio = 0.0, .density = 1000.0};
};

inline Frame cantilever(const CantileverShape& shape = {}) {
    Frame frame;
    frame.nodes = {{0, 0, 0}, {shape.length, 0, 0}};
    frame.beams.push_back({.nodes = {NodeIndex(0), NodeIndex(1)},
                           .section = shape.section,
                           .material = shape.material,
                           .divisions = shape.divisions});
    clamp(frame, 0);
    return frame;
}

/// A star of beams in space, clamped at its three tips and loaded at its center, node 0.
inline Frame star() {
    Frame frame;
    frame.nodes = {{0, 0, 0}, {0.03, 0.002, 0.001}, {-0.01, 0.025, -0.004}, {-0.012, -0.02, 0.006}};
    for (int tip = 1; tip < 4; ++tip) {
        frame.beams.push_back(beam_between(0, tip));
        clamp(frame, tip);
    }
    frame.loads.push_back({NodeIndex(0), {0.3, -0.2, 1.0}, {0.001, 0.002, -0.001}});
    return frame;
}

/// A flat ring of six beams with six spokes outwards, clamped at the tips of the first two: nodes 0 to 5 are
/// the tips, 6 to 11 the ring.
inline Frame flat_wheel() {
    Frame frame;
    for (const double radius : {0.026, 0.013}) {
        for (int i = 0; i < 6; ++i) {
            const double angle = std::numbers::pi / 3.0 * i + (radius < 0.02 ? 0.2 : 0.0);
            frame.nodes.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
        }
    }
    for (int i = 0; i < 6; ++i) {
        frame.beams.push_back(beam_between(i, i + 6));
        frame.beams.push_back(beam_between(i + 6, (i + 1) % 6 + 6));
    }
    clamp(frame, 0);
    clamp(frame, 1);
    return frame;
}

/// Hexagons: rows of zigzags, each joined to the next one at every second node. Clamped at its left side, and
/// pulled and lifted at its right one.
inline Frame honeycomb(int columns, int rows) {
    constexpr double kSide = 0.01;
    Frame frame;
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const double up = (i + j) % 2 == 0 ? 0.5 : 0.0;
            frame.nodes.emplace_back(0.866 * kSide * i, kSide * (1.5 * j + up), 0.0);
            const int node = j * columns + i;
            if (i > 0) frame.beams.push_back(beam_between(node - 1, node));
            if (j + 1 < rows && up > 0.0) frame.beams.push_back(beam_between(node, node + columns));
        }
    }
    for (int j = 0; j < rows; ++j) {
        clamp(frame, j * columns);
        const NodeIndex right((j + 1) * columns - 1);
        frame.loads.push_back({right, {1e-3, 0.0, 2e-3}, {0.0, 1e-6, 0.0}});
    }
    // A partly held rotation, and a prescribed displacement.
    frame.supports.push_back({NodeIndex(columns / 2), {{false, false, false, true, false, true}}});
    frame.prescribed.push_back({NodeIndex(columns / 2), Dof::uz, 1e-4});
    return frame;
}

}  // namespace fretwork::mechanics::sample

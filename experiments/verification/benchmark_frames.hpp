// SPDX-License-Identifier: GPL-3.0-or-later
// The frames of published benchmarks, each with its source, in its units; loads at factor 1 are the critical
// or full ones. Critical loads are those of the geometrically exact rod (shooting.py), since sources print
// three or four digits, from few elements. The tests and the experiment use the same frames.
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>

#include <cmath>
#include <numbers>

namespace fretwork::verification {

using mechanics::Beam;
using mechanics::DofSet;
using mechanics::Frame;
using mechanics::NodeIndex;

inline void clamp(Frame& frame, int node) {
    frame.supports.push_back({NodeIndex(node), DofSet::all()});
}

/// Clamped at the origin, along x.
inline Frame cantilever(double length, const Beam& like) {
    Frame frame;
    frame.nodes = {{0, 0, 0}, {length, 0, 0}};
    frame.beams = {like};
    frame.beams[0].nodes = {NodeIndex(0), NodeIndex(1)};
    clamp(frame, 0);
    return frame;
}

/// Length and bending stiffnesses one; nearly inextensible: E A L^2 / E I = 1e9, so that the inextensible
/// rod's formulas hold to 1e-8.
inline Frame thin_cantilever(int divisions) {
    return cantilever(1.0, {.nodes = {},
                            .section = {.area = 1.0, .I2 = 1e-9, .I3 = 1e-9, .J = 2e-9},
                            .material = {.young_modulus = 1e9, .poisson_ratio = 0.0},
                            .divisions = divisions});
}

/// A column under Euler's load, pi^2 E I / 4 L^2, that bends more easily along z than along y.
inline Frame euler_column(int divisions) {
    Frame frame = cantilever(1.0, {.nodes = {},
                                   .section = {.area = 10.0, .I2 = 1e-6, .I3 = 2e-6, .J = 2.5e-6},
                                   .material = {.young_modulus = 1e9, .poisson_ratio = 0.0},
                                   .divisions = divisions});
    frame.loads.push_back({NodeIndex(1), {-std::numbers::pi * std::numbers::pi / 4.0 * 1e3, 0.0, 0.0}});
    return frame;
}

/// Bathe and Bolourchi (1979): an eighth of a circle of radius 100, clamped, pulled out of its plane by 600.
/// Straight beams are a polygon in the arc: its error falls with the square of their number.
inline Frame bathe_bolourchi_bend(int beams, double torsion_constant) {
    Frame frame;
    for (int i = 0; i <= beams; ++i) {
        const double angle = std::numbers::pi / 4.0 * i / beams;
        frame.nodes.emplace_back(100.0 * std::sin(angle), 100.0 * (1.0 - std::cos(angle)), 0.0);
    }
    for (int i = 0; i < beams; ++i) {
        frame.beams.push_back(
            {.nodes = {NodeIndex(i), NodeIndex(i + 1)},
             .section = {.area = 1.0, .I2 = 1.0 / 12.0, .I3 = 1.0 / 12.0, .J = torsion_constant},
             .material = {.young_modulus = 1e7, .poisson_ratio = 0.0}});
    }
    clamp(frame, 0);
    frame.loads.push_back({NodeIndex(beams), {0.0, 0.0, 600.0}});
    return frame;
}

/// Keep a frame in the plane y = 0.
inline void hold_in_plane(Frame& frame) {
    for (std::size_t i = 0; i < frame.nodes.size(); ++i)
        frame.supports.push_back({NodeIndex(i), {{false, true, false, true, false, true}}});
}

/// Go on from the last node to `end` by a given number of beams.
inline void add_leg(Frame& frame, Beam like, const Eigen::Vector3d& end, int beams) {
    const Eigen::Vector3d start = frame.nodes.back();
    for (int k = 1; k <= beams; ++k) {
        frame.nodes.push_back(start + (end - start) * k / beams);
        const int last = static_cast<int>(frame.nodes.size()) - 1;
        like.nodes = {NodeIndex(last - 1), NodeIndex(last)};
        frame.beams.push_back(like);
    }
}

/// Lee, Manuel and Rossow (1968): legs of 120, hinged at both feet, the load at a fifth of the upper leg,
/// node 10. Sources print 18557.
inline Frame lee_frame() {
    const Beam bar{.nodes = {},
                   .section = {.area = 6.0, .I2 = 2.0, .I3 = 2.0, .J = 4.0},
                   .material = {.young_modulus = 7.2e6, .poisson_ratio = 0.3}};
    Frame frame;
    frame.nodes = {{0, 0, 0}};
    add_leg(frame, bar, {0, 0, 120}, 8);
    add_leg(frame, bar, {24, 0, 120}, 2);
    add_leg(frame, bar, {120, 0, 120}, 8);
    hold_in_plane(frame);
    for (const int foot : {0, 18}) frame.supports.push_back({NodeIndex(foot), DofSet::translations()});
    frame.loads.push_back({NodeIndex(10), {0.0, 0.0, -18556.73}});
    return frame;
}

/// Williams (1964): a toggle of two flat clamped bars, in inches and pounds; the apex is node 4. The load is
/// reached at an apex moved by 0.23216. Sources print 33.98.
inline Frame williams_toggle() {
    const double width = 0.753;
    const double height = 0.243;
    const Beam bar{.nodes = {},
                   .section = {.area = width * height,
                               .I2 = width * std::pow(height, 3) / 12.0,
                               .I3 = height * std::pow(width, 3) / 12.0,
                               .J = 0.003},
                   .material = {.young_modulus = 1.03e7, .poisson_ratio = 0.3},
                   .divisions = 8};
    Frame frame;
    frame.nodes = {{-12.943, 0, 0}};
    add_leg(frame, bar, {0, 0, 0.386}, 4);
    add_leg(frame, bar, {12.943, 0, 0}, 4);
    hold_in_plane(frame);
    clamp(frame, 0);
    clamp(frame, 8);
    frame.loads.push_back({NodeIndex(4), {0.0, 0.0, -33.87039}});
    return frame;
}

/// Argyris' strip, 30 deep in the plane of the frame and 0.6 thick; axis 3 is out of the plane.
inline Beam argyris_strip(int from, int to) {
    return {.nodes = {NodeIndex(from), NodeIndex(to)},
            .section = {.area = 18.0, .I2 = 30.0 * 0.216 / 12.0, .I3 = 0.6 * 27000.0 / 12.0, .J = 2.16},
            .material = {.young_modulus = 71240.0, .poisson_ratio = 0.31},
            .divisions = 64};
}

/// Argyris et al., Comp. Meth. Appl. Mech. Eng. 20 (1979): a right angle of two legs, clamped at one end,
/// pulled at the other along the clamped leg. The source prints 1.088; an independent
/// corotational program gave 1.089.
inline Frame right_angle_frame() {
    Frame frame;
    frame.nodes = {{0, 0, 0}, {240, 0, 0}, {240, -240, 0}};
    frame.beams = {argyris_strip(0, 1), argyris_strip(1, 2)};
    clamp(frame, 0);
    frame.loads.push_back({NodeIndex(2), {1.08752, 0.0, 0.0}});
    return frame;
}

/// The same with hinged ends that turn in the plane and slide along their line, under opposite end moments
/// times `sign`. The source prints 624.77, Simo and Vu-Quoc (1986) 626; an independent
/// corotational program gave 624.6.
inline Frame hinged_right_angle_frame(double sign) {
    const double half = 240.0 / std::numbers::sqrt2;
    Frame frame;
    frame.nodes = {{-half, 0, 0}, {0, half, 0}, {half, 0, 0}};
    frame.beams = {argyris_strip(0, 1), argyris_strip(1, 2)};
    for (const int end : {0, 2})
        frame.supports.push_back({NodeIndex(end), {{false, true, true, true, true, false}}});
    frame.supports.push_back({NodeIndex(1), {{true, false, false, false, false, false}}});
    frame.loads.push_back({NodeIndex(0), Eigen::Vector3d::Zero(), {0.0, 0.0, 622.222 * sign}});
    frame.loads.push_back({NodeIndex(2), Eigen::Vector3d::Zero(), {0.0, 0.0, -622.222 * sign}});
    return frame;
}

/// Ibrahimbegovic, Comp. Meth. Appl. Mech. Eng. 122 (1995): ten turns under a moment of 200 pi about z,
/// pulled into a helix by 50 along z; with shear.
inline Frame helix_cantilever(int divisions) {
    Beam rod{.nodes = {},
             .section = {.area = 1.0, .I2 = 0.01, .I3 = 0.01, .J = 0.01},
             .material = {.young_modulus = 1e4},
             .divisions = divisions};
    rod.section.shear_area2 = rod.section.shear_area3 = 1.0;
    rod.material.given_shear_modulus = 1e4;
    Frame frame = cantilever(10.0, rod);
    frame.loads.push_back({NodeIndex(1), {0.0, 0.0, 50.0}, {0.0, 0.0, 200.0 * std::numbers::pi}});
    return frame;
}

/// Hockling (Simo and Vu-Quoc 1986): a shaft whose ends cannot bend, under a torque at the end that slides
/// and turns: 2 * 4.493409 E I / L, where 4.493409 is the first root of tan x = x.
inline Frame hockling_shaft() {
    Beam shaft{.nodes = {},
               .section = {.area = 1.0, .I2 = 0.0833, .I3 = 0.0833, .J = 2.16},
               .material = {.young_modulus = 71240.0},
               .divisions = 16};
    shaft.material.given_shear_modulus = 27190.0;
    Frame frame = cantilever(240.0, shaft);
    frame.supports.push_back({NodeIndex(1), {{false, true, true, false, true, true}}});
    frame.loads.push_back(
        {NodeIndex(1), Eigen::Vector3d::Zero(), {2.0 * 4.493409 * 71240.0 * 0.0833 / 240.0, 0.0, 0.0}});
    return frame;
}

}  // namespace fretwork::verification

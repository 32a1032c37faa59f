#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact values of the benchmarks, without beam elements: the equations of the geometrically exact rod (Reissner, Simo),
integrated from one end and shot at the conditions of the other. Usage: shooting.py      (three minutes; Debian's python3-scipy)

A leg is a straight or evenly curved piece of rod. Stiffnesses: E A, shear (infinite: none), E I2, E I3, G J. Forces act in
fixed directions. Cross-section axes: 1 along the rod, 2 and 3 across; in frames of one plane, 3 is out of it.
"""
import math
from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, fsolve, minimize_scalar

Z = np.array([0.0, 0.0, 1.0])


@dataclass
class Leg:
    length: float
    axial: float  # E A
    bending2: float
    bending3: float
    torsion: float  # G J
    shear: float = math.inf
    curvature: float = 0.0  # about axis 3, at rest


def skew(v):
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def about_z(angle):
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])


@dataclass
class Cut:
    """What is known of a cross-section: place, axes (columns), force and moment that the rod behind exerts on that before."""

    place: np.ndarray
    axes: np.ndarray
    force: np.ndarray
    moment: np.ndarray


def along(leg, start):
    """The cut at the end of a leg that begins with `start`."""

    def rate(_, state):
        axes, force, moment = state[3:12].reshape(3, 3), start.force, state[12:15]
        own_force, own_moment = axes.T @ force, axes.T @ moment
        strain = own_force / np.array([leg.axial, leg.shear, leg.shear]) + np.array([1.0, 0, 0])
        curvature = own_moment / np.array([leg.torsion, leg.bending2, leg.bending3]) + leg.curvature * Z
        tangent = axes @ strain
        return np.concatenate([tangent, (axes @ skew(curvature)).ravel(), -np.cross(tangent, force)])

    state = np.concatenate([start.place, start.axes.ravel(), start.moment])
    end = solve_ivp(rate, (0, leg.length), state, method="DOP853", rtol=1e-11, atol=1e-13).y[:, -1]
    return Cut(end[:3], end[3:12].reshape(3, 3), start.force, end[12:15])


def loaded(cut, force):
    """Behind a point load."""
    return Cut(cut.place, cut.axes, cut.force - force, cut.moment)


def turned(cut, angle):
    """Behind a rigid corner of the plane."""
    return Cut(cut.place, cut.axes @ about_z(angle), cut.force, cut.moment)


def solved(conditions, guess, scale):
    """The root of conditions of unknowns of these scales."""
    scale = np.asarray(scale, float)
    root, _, found, message = fsolve(lambda x: conditions(x * scale), np.asarray(guess) / scale, full_output=True, xtol=1e-12)
    if found != 1:
        raise RuntimeError(message)
    return root * scale


def limit_load(load_at, bracket):
    """The largest load over the moves of its point within a bracket."""
    found = minimize_scalar(lambda move: -load_at(move), bounds=bracket, method="bounded", options={"xatol": 1e-7 * bracket[1]})
    return -found.fun, found.x


def williams_toggle():
    """Half of it: clamped at the foot; the apex moves down and does not turn."""
    width, height, modulus = 0.753, 0.243, 1.03e7
    span, rise = 12.943, 0.386
    slope = math.atan2(rise, span)
    leg = Leg(math.hypot(span, rise), modulus * width * height, 1e6, modulus * width * height**3 / 12, 1e6)
    last = [np.array([-300.0, -5.0, 10.0])]

    def load_at(move):
        def conditions(unknowns):
            end = along(leg, Cut(np.zeros(3), about_z(slope), np.array([*unknowns[:2], 0]), unknowns[2] * Z))
            return [end.place[0] - span, end.place[1] - rise + move, end.axes[1, 0] - math.sin(slope)]

        last[0] = solved(conditions, last[0], [100, 10, 10])
        return -2 * last[0][1]

    return limit_load(load_at, (0.15, 0.3))


def lee_frame():
    """Hinged at both feet; the load at a fifth of the upper leg."""
    modulus, area, inertia = 7.2e6, 6.0, 2.0
    leg = lambda length: Leg(length, modulus * area, 1e9, modulus * inertia, 1e9)
    last = [np.array([-3000.0, -10000.0, 0.1, 10000.0])]

    def load_at(move):
        def conditions(unknowns):
            x, y, turn, load = unknowns
            corner = along(leg(120), Cut(np.zeros(3), about_z(math.pi / 2 + turn), np.array([x, y, 0]), np.zeros(3)))
            below = along(leg(24), turned(corner, -math.pi / 2))
            end = along(leg(96), loaded(below, np.array([0, -load, 0])))
            return [end.place[0] - 120, end.place[1] - 120, end.moment[2] / 1e4, below.place[1] - 120 + move]

        last[0] = solved(conditions, last[0], [1e4, 1e4, 0.1, 1e4])
        return last[0][3]

    for move in np.linspace(2, 40, 20):
        load_at(move)
    return limit_load(load_at, (40.0, 60.0))


def critical(state_at, bracket):
    """The load at which a plane state has a neighbour out of its plane. `state_at(load)` gives the map from small unknowns out
    of the plane at one end to the conditions of the other, and small steps of them."""

    def determinant(load):
        conditions, steps = state_at(load)
        return np.linalg.det([conditions(step) - conditions(-step) for step in np.diag(steps)])

    return brentq(determinant, *bracket, xtol=1e-9 * bracket[1])


def argyris_leg(length=240.0):
    modulus, poisson, width, depth = 71240.0, 0.31, 0.6, 30.0
    shear_modulus = modulus / (2 * (1 + poisson))
    return Leg(length, modulus * width * depth, modulus * depth * width**3 / 12, modulus * width * depth**3 / 12, shear_modulus * 2.16)


def right_angle_frame():
    """Clamped at one end, pulled at the other along the clamped leg."""
    leg = argyris_leg()

    def state_at(load):
        force = np.array([load, 0, 0])

        def end(moment):
            corner = along(leg, Cut(np.zeros(3), np.eye(3), force, moment))
            return along(leg, turned(corner, -math.pi / 2)).moment

        in_plane = solved(lambda m: [end(m[0] * Z)[2]], [-240 * load], [100])[0]
        return (lambda small: end(in_plane * Z + np.array([*small, 0]))[:2]), (1e-2, 1e-2)

    return critical(state_at, (1.0, 1.2))


def hinged_right_angle_frame(sign):
    """The ends turn in the plane and slide along their line, under opposite moments."""
    leg = argyris_leg()

    def state_at(moment):
        def end(turn, force, start_moment):
            # The rod behind exerts on the end what balances the load there.
            corner = along(leg, Cut(np.zeros(3), about_z(math.pi / 4 + turn), force, start_moment))
            return along(leg, turned(corner, -math.pi / 2))

        held = -sign * moment * Z
        turn = solved(lambda t: [end(t[0], np.zeros(3), held).place[1]], [0.0], [1e-3])[0]

        def conditions(small):
            last = end(turn, small[0] * Z, held + np.array([*small[1:], 0]))
            return np.array([last.place[2], last.axes[2, 0], last.axes[2, 1]])

        return conditions, (1e-5, 1e-2, 1e-2)

    return critical(state_at, (615.0, 630.0))


def bend():
    """An eighth of a circle of radius 100, pulled out of its plane."""
    modulus = 1e7
    stiffness = modulus / 12
    force = np.array([0, 0, 600.0])
    torsion = modulus / 2 * (1 / 6)
    last = np.zeros(3)
    for share in (0.05, 0.1, 0.2, 0.35, 0.5, 0.65, 0.8, 0.9, 1.0):
        leg = Leg(100 * math.pi / 4, modulus, stiffness, stiffness, torsion, curvature=0.01)
        end = lambda moment: along(leg, Cut(np.zeros(3), np.eye(3), share * force, moment))
        last = solved(lambda moment: end(moment).moment, last, [1e4] * 3)
    return end(last).place - 100 * np.array([math.sin(math.pi / 4), 1 - math.cos(math.pi / 4), 0])


def helix():
    """A cantilever wound up by a moment about z and pulled along z; with shear. The tip at a tenth of the load, and at all of it."""
    leg = Leg(10.0, 1e4, 100.0, 100.0, 100.0, shear=1e4)
    tips = []
    last = np.zeros(3)
    for share in np.linspace(0.005, 1.0, 200):
        end = lambda moment: along(leg, Cut(np.zeros(3), np.eye(3), share * 50 * Z, moment))
        last = solved(lambda moment: end(moment).moment - share * 200 * math.pi * Z, last, [100] * 3)
        tips.append(end(last).place - np.array([10.0, 0, 0]))
    return tips[19], tips[-1]


def main():
    load, move = williams_toggle()
    print(f"Williams' toggle: limit load {load:.5f} at an apex moved by {move:.5f}")
    load, move = lee_frame()
    print(f"Lee's frame: first limit load {load:.2f} at a point moved by {move:.3f}")
    print(f"right-angle frame, tip force: critical load {right_angle_frame():.5f}")
    for sign in (1, -1):
        print(f"right-angle frame, end moments of sign {sign}: critical moment {hinged_right_angle_frame(sign):.3f}")
    print("45-degree bend: tip moved by", *(f"{value:.4f}" for value in bend()))
    for tip, share in zip(helix(), ("a tenth of", "all of")):
        print(f"helix, {share} the load: tip moved by", *(f"{value:.5f}" for value in tip))


if __name__ == "__main__":
    main()

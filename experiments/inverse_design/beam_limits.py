#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How near a beam comes to the shapes of shapes.cpp if its bending stiffness is free along its length.

A planar, inextensible beam (elastica) with eleven pieces, as many as the lattice has columns. The stiffness of each piece is
free between 1 and 9, the range of the 1,824 patterns as plates, and so are the factors on the loads. What it leaves is left
by the load, the range of stiffness and the number of pieces, and not by the search of a painting. Least squares from several
starts: found, not proven. For the two load cases, two more rows: beams of any stiffness at every place, which is convex, and
the same two arcs under two tip forces. Needs numpy and scipy. Usage: beam_limits.py
"""
import math

import numpy
from scipy.optimize import brentq, least_squares, minimize, minimize_scalar

PIECES = 11
STEPS = 20  # of a piece
RANGE = 9.0
LENGTH = 1.0


def pieces(stiffness):
    return numpy.repeat(stiffness, STEPS)


def from_tip(stiffness, shear, angle):
    """The points from the tip to the clamp, and the angle there. shear: the vertical force that acts between the tip and here."""
    step = LENGTH / (PIECES * STEPS)
    x = z = moment = 0.0
    points = [(x, z)]
    for ei, force in zip(pieces(stiffness)[::-1], shear):
        half = 0.5 * step * force * math.cos(angle)  # by the middle of the step the moment has grown by half
        angle -= step * (moment + half) / ei
        moment += 2.0 * half
        x -= step * math.cos(angle)
        z -= step * math.sin(angle)
        points.append((x, z))
    return numpy.array(points), angle


def tip_force(force):
    return numpy.full(PIECES * STEPS, force)


def pressure(total):
    """A vertical load, the same on each length of the beam."""
    return total * (numpy.arange(PIECES * STEPS) + 0.5) / (PIECES * STEPS)


def cantilever(stiffness, load):
    """The places of points along a cantilever that is clamped at 0."""
    clamp = lambda angle: from_tip(stiffness, load, angle)[1]
    high = 0.1
    while clamp(high) < 0.0 and high < 3.0:
        high += 0.2
    angle = brentq(clamp, -0.5, high, xtol=1e-10)
    points = from_tip(stiffness, load, angle)[0]
    return (points - points[-1])[::-1]


def curvature_response(angle, count):
    """The displacements of an arc by changes of the curvature of its steps, at first order: rows x, then z."""
    step = LENGTH / (count - 1)
    middle = (numpy.arange(count - 1) + 0.5) * step * angle / LENGTH
    turn = numpy.tril(numpy.ones((count - 1, count - 1))) * step  # of a step by the curvatures up to its end
    turn -= 0.5 * step * numpy.eye(count - 1)                     # at its middle
    sums = numpy.vstack([numpy.zeros(count - 1), numpy.tril(numpy.ones((count - 1, count - 1)))]) * step
    return numpy.vstack([sums @ (-numpy.sin(middle)[:, None] * turn), sums @ (numpy.cos(middle)[:, None] * turn)])


def two_of_any_stiffness(up, down, count):
    """The least mean distance of two arcs, one under a tip force and one under a vertical pressure, of a beam with any
    positive stiffness at every place. The moments are those on the wanted arcs, so the ratio of the two curvatures is known
    up to the ratio g of the loads: k_down = g w k_up. With g given, the mean distance is convex in k_up; g is scanned."""
    s = (numpy.arange(count - 1) + 0.5) * LENGTH / (count - 1)
    place = lambda angle, at: LENGTH / angle * numpy.sin(angle * at / LENGTH)
    moment_up = place(up, LENGTH) - place(up, s)
    rest = LENGTH - s  # the load on the rest of the beam, and the centre of it
    centre = (LENGTH / down) ** 2 * (numpy.cos(down * s / LENGTH) - math.cos(down)) / rest
    moment_down = rest * (centre - place(down, s))
    w = moment_down / moment_up
    largest = numpy.linalg.norm(arc(up, count)[-1] - [LENGTH, 0.0])
    a, b = curvature_response(up, count) / largest, curvature_response(down, count) / largest

    def least(g):
        matrix = numpy.vstack([a, b * (g * w)[None, :]])
        wanted = numpy.concatenate([a @ numpy.full(count - 1, up / LENGTH), b @ numpy.full(count - 1, down / LENGTH)])

        def mean(k):  # a smooth sum of lengths, and its gradient
            rows = (matrix @ k - wanted).reshape(2, 2, count)
            lengths = numpy.sqrt((rows ** 2).sum(axis=1) + 1e-16)
            return lengths.mean(), matrix.T @ (rows / lengths[:, None, :]).ravel() / lengths.size

        start = numpy.full(count - 1, up / LENGTH)
        return minimize(mean, start, jac=True, method="L-BFGS-B", bounds=[(0.0, None)] * (count - 1),
                        options={"maxiter": 20000, "maxfun": 40000, "ftol": 1e-15, "gtol": 1e-12}).fun

    ratios = down / up / w.mean() * numpy.geomspace(0.25, 4.0, 17)
    at = int(numpy.argmin([least(g) for g in ratios[1:-1]])) + 1
    return minimize_scalar(least, bounds=(ratios[at - 1], ratios[at + 1]), method="bounded", options={"xatol": 1e-3 * ratios[at]}).fun


def arch(stiffness, start_angle):
    """Half of a symmetric strut between pins, from the pin at 0: the thrust is such that the middle is level."""
    half = pieces(stiffness)[:PIECES * STEPS // 2]
    step = LENGTH / (PIECES * STEPS)

    def run(thrust):
        x = z = 0.0
        angle = start_angle
        points = [(x, z)]
        for ei in half:
            angle -= step * thrust * z / ei
            x += step * math.cos(angle)
            z += step * math.sin(angle)
            points.append((x, z))
        return numpy.array(points), angle

    high = 1.0
    while run(high)[1] > 0.0:
        high *= 1.5
    thrust = brentq(lambda value: run(value)[1], 0.0, high, xtol=1e-9)
    return run(thrust)[0]


def arc(angle, count):
    s = numpy.linspace(0.0, LENGTH, count)
    radius = LENGTH / angle
    return numpy.stack([radius * numpy.sin(s / radius), radius * (1.0 - numpy.cos(s / radius))], axis=1)


def best(shapes, targets, guesses):
    """Mean distance in shares of the largest displacement wanted; shapes(unknowns) are those of the targets."""
    rest = [numpy.stack([numpy.linspace(0.0, LENGTH, PIECES * STEPS + 1)[:len(t)], numpy.zeros(len(t))], axis=1) for t in targets]
    largest = max(numpy.linalg.norm(t - r, axis=1).max() for t, r in zip(targets, rest))
    found = None
    for guess, low, high in guesses:
        fit = least_squares(lambda u: numpy.concatenate([(a - b).ravel() for a, b in zip(shapes(u), targets)]), guess,
                            bounds=(low, high), x_scale=1.0)
        distances = numpy.concatenate([numpy.linalg.norm(a - b, axis=1) for a, b in zip(shapes(fit.x), targets)]) / largest
        if found is None or fit.cost < found[0]:
            found = (fit.cost, distances.mean(), numpy.exp(fit.x[:PIECES]))
    return found[1], found[2]


def guesses(more, low, high):
    """Logarithms of the stiffness: even, and falling towards the tip."""
    top = math.log(RANGE)
    bounds = ([0.0] * PIECES + low, [top] * PIECES + high)
    for shape in (numpy.full(PIECES, 0.5 * top), numpy.linspace(0.95 * top, 0.05 * top, PIECES)):
        yield numpy.concatenate([shape, more]), *bounds


def report(name, found):
    share, stiffness = found
    print(f"| {name} | {100.0 * share:.2g} | {' '.join(f'{value:.1f}' for value in stiffness)} |", flush=True)


def main():
    count = PIECES * STEPS + 1
    print("| shape | mean distance, % of the largest displacement wanted | stiffness of the pieces |")
    print("|---|---|---|")
    for degrees in (60, 90):
        target = arc(math.radians(degrees), count)
        report(f"arc of {degrees} degrees, tip force",
               best(lambda u: [cantilever(numpy.exp(u[:PIECES]), tip_force(math.exp(u[PIECES])))], [target],
                    guesses([math.log(4.0)], [-3.0], [4.0])))
    up, down = arc(math.radians(45), count), arc(math.radians(25), count)
    report("two: arc of 45 degrees under a tip force, of 25 under a pressure",
           best(lambda u: [cantilever(numpy.exp(u[:PIECES]), tip_force(math.exp(u[PIECES]))),
                           cantilever(numpy.exp(u[:PIECES]), pressure(math.exp(u[PIECES + 1])))], [up, down],
                guesses([math.log(3.0), math.log(4.0)], [-3.0, -3.0], [4.0, 4.0])))
    print(f"| the same two of any stiffness at every place, convex | {100.0 * two_of_any_stiffness(math.radians(45), math.radians(25), 111):.2g} | |")
    report("two: arcs of 45 and of 25 degrees, each under a tip force",
           best(lambda u: [cantilever(numpy.exp(u[:PIECES]), tip_force(math.exp(u[PIECES]))),
                           cantilever(numpy.exp(u[:PIECES]), tip_force(math.exp(u[PIECES + 1])))], [up, down],
                guesses([math.log(3.0), math.log(1.5)], [-3.0, -3.0], [4.0, 4.0])))
    angle = math.radians(60)
    s = numpy.linspace(0.0, LENGTH, count)[:PIECES * STEPS // 2 + 1] - 0.5 * LENGTH
    radius = LENGTH / angle
    places = numpy.stack([radius * numpy.sin(s / radius) + radius * math.sin(angle / 2),
                          radius * (numpy.cos(s / radius) - math.cos(angle / 2))], axis=1)
    symmetric = lambda u: 0.5 * (u[:PIECES] + u[:PIECES][::-1])
    def centred(points):  # the middle is where it is, however far both ends are pushed in
        return points + numpy.array([places[-1, 0] - points[-1, 0], 0.0])
    report("arch of 60 degrees between pins, pushed in",
           best(lambda u: [centred(arch(numpy.exp(symmetric(u)), u[PIECES]))], [places], guesses([0.5], [0.05], [1.5])))


main()

#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Write annealing_trace.csv: what simulated annealing does on a quadratic, step by step.

Written from the published description of ensmallen's SA (one variable a move in turn, Laplace moves, Metropolis' rule,
feedback on the acceptance, exponential cooling after the initial moves) and shares no code with the library: not even the
random numbers, which are Philox4x32-10 again. Usage: annealing_trace.py > annealing_trace.csv
"""
import math

MASK = 0xFFFFFFFF


def philox(counter, key):
    c, k = list(counter), list(key)
    for _ in range(10):
        a, b = 0xD2511F53 * c[0], 0xCD9E8D57 * c[2]
        c = [(b >> 32) ^ c[1] ^ k[0], b & MASK, (a >> 32) ^ c[3] ^ k[1], a & MASK]
        k = [(k[0] + 0x9E3779B9) & MASK, (k[1] + 0xBB67AE85) & MASK]
    return c


class Stream:
    def __init__(self, seed, stream):
        self.key = (seed & MASK, seed >> 32)
        self.stream = (stream & MASK, stream >> 32)
        self.draws = 0

    def uniform(self):
        w = philox((self.draws & MASK, self.draws >> 32) + self.stream, self.key)
        self.draws += 1
        return (((w[0] << 20) ^ (w[1] >> 12)) + 0.5) * 2.0**-52


def reflect(share):
    folded = math.fmod(abs(share), 2.0)
    return 2.0 - folded if folded > 1.0 else folded


def energy(x):
    return 10.0 * ((x[0] - 0.3) ** 2 + (x[1] - 0.7) ** 2)


def anneal(seed, initial_temperature=1e4, initial_moves=1000, cooling=1e-3, sweeps=100, tolerance=1e-5, frozen=3):
    """Yield (move, proposal, its energy, whether it is accepted, temperature) for each move in the box [0, 1]^2."""
    shift = Stream(seed, 0x5A3D1E7000000000)
    x = [shift.uniform(), shift.uniform()]
    random = Stream(seed, 0)
    n, current, temperature = len(x), energy(x), initial_temperature
    scale, accepted, still, move = [0.3] * n, [0] * n, 0, 0
    while still < frozen * sweeps * n:
        i = move % n
        u = random.uniform() - 0.5
        step = scale[i] * math.log1p(2.0 * u) if u < 0.0 else -scale[i] * math.log1p(-2.0 * u)
        proposal = list(x)
        proposal[i] = reflect(x[i] + step)
        new, chance, before = energy(proposal), random.uniform(), current
        is_accepted = new <= current or chance < math.exp(-(new - current) / temperature)
        if is_accepted:
            x, current = proposal, new
            accepted[i] += 1
        move += 1
        yield move, proposal, new, is_accepted, temperature
        if move % (sweeps * n) == 0:
            scale = [min(s * math.exp(0.3 * (a / sweeps - 0.44)), 20.0) for s, a in zip(scale, accepted)]
            accepted = [0] * n
        if move > initial_moves:
            temperature *= 1.0 - cooling
            still = still + 1 if abs(current - before) < tolerance else 0


def write(case, every, moves, **options):
    for move, x, value, is_accepted, temperature in anneal(**options):
        if move % every == 0:
            print(f"{case},{move},{x[0]!r},{x[1]!r},{value!r},{int(is_accepted)},{temperature!r}")
        if move == moves:
            return
    print(f"{case},{move},{x[0]!r},{x[1]!r},{value!r},{int(is_accepted)},{temperature!r}")


if __name__ == "__main__":
    print("case,move,x0,x1,energy,accepted,temperature")
    write("short", 1, 300, seed=5, initial_temperature=10.0, initial_moves=40, cooling=0.02, sweeps=10)
    write("default", 500, None, seed=11)

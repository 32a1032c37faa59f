# SPDX-License-Identifier: GPL-3.0-or-later
"""No call crashes: every function and method of the module with wrong and half-right values, from a seed.

The calls run in a process of their own; what it raises does not count, that it ends by itself does.
"""

import os
import subprocess
import sys
import unittest

CALLS = 4000

PROGRAM = r"""
import enum, inspect, random, sys, signal
import numpy as np
import fretwork as fw
import support

random = random.Random(int(sys.argv[1]))
layout, surface, case = fw.paper_layout(), support.surface(), support.tip()
other = fw.find_node_layout("fifths12")
pattern = fw.parse_pattern_id(layout, support.PATTERN)
session = fw.Session(surface, case, model="condensed")
result = session.solve(subject=True)
setting = fw.paper_setting()
setting.magnitudes = 1
bowl = fw.Problem("bowl", [-1, -1], [2, 2], value=lambda x: float(x @ x))
refused, bare = 0, []
for kind in vars(fw).values():
    if type(kind).__name__ == "pybind11_type":
        try:
            bare.append(kind.__new__(kind))
        except TypeError:
            refused += 1
assert refused >= 10, refused  # Session, Library, NodeLayout, CandidateTiles, Problem, Filter, TileModel, Shape, ..
pool = [None, True, -1, 0, 1, 3, 2**40, float("nan"), 1e300, -0.5, "", "x", "0-1+1-6", "\0", b"bytes", [], [1], [-5], [10**6],
        [[1, 2], [3, 4]], {}, {"a": 1}, object(), int, len, lambda *a: None, np.zeros((0, 6)), np.zeros((3, 3)), np.full((2, 6), np.nan),
        np.array(["a"]), layout, other, pattern, fw.Pattern([127]), fw.Pattern(), surface, support.project(), case, fw.LoadCase(),
        session, result, result.solution, setting, fw.Setting(), fw.Scenario(), bowl, support.cantilever(), fw.Frame(),
        fw.make_fan(layout, pattern), fw.make_fan(other, fw.Pattern([0, 5])), fw.rectangle_section(1, 1), fw.Section(),
        fw.Filter("f", lambda p: True), fw.EnumerationOptions(), fw.tile_models()[0], surface.tessellation, *bare]
slow = {"enumerate_patterns", "for_each_pattern", "count_patterns", "take_census", "find_rejections", "PatternSampler",
        "find_sameness", "minimize", "draw", "estimate", "fill", "provenance"}


def targets():
    for name, part in support.public_parts(also=("__contains__", "__eq__", "__reduce__")):
        owner = getattr(fw, name.partition(".")[0])
        is_fixed = inspect.isclass(owner) and issubclass(owner, (enum.Enum, Exception))
        if callable(part) and not is_fixed and slow.isdisjoint(name.split(".")):
            yield name, part


class Enough(Exception):
    pass


def stop(*_):
    raise Enough


signal.signal(signal.SIGALRM, stop)
known = list(targets())
raised = 0
for call in range(int(sys.argv[2])):
    name, function = random.choice(known)
    arguments = [random.choice(pool) for _ in range(random.randint(0, 5))]
    keywords = {"threads": random.choice(pool)} if random.random() < 0.1 else {}
    print(call, name, file=sys.stderr)
    signal.setitimer(signal.ITIMER_REAL, 2.0)
    try:
        function(*arguments, **keywords)
    except (Exception, Enough):
        raised += 1
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
print(len(known), raised)
"""


class Misuse(unittest.TestCase):
    def test_no_call_crashes(self):
        for seed in (1, 2, 3):
            with self.subTest(seed=seed):
                done = subprocess.run([sys.executable, "-B", "-c", PROGRAM, str(seed), str(CALLS)], capture_output=True,
                                      text=True, cwd=os.path.dirname(os.path.abspath(__file__)))
                last = "\n".join(done.stderr.splitlines()[-60:])  # the call, and what a sanitizer says of it
                self.assertEqual(done.returncode, 0, f"ended by {done.returncode} at: {last}")
                functions, raised = map(int, done.stdout.split()[-2:])
                self.assertGreater(functions, 200)
                self.assertGreater(raised, CALLS // 2)


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""What the Python module costs beside C++: import, edits of a session, reading a library, a gradient, Ctrl-C.

Usage: PYTHONPATH=build/release/apps/python /usr/bin/python3 bench/python_bench.py
"""

import os
import signal
import statistics
import subprocess
import sys
import tempfile
import threading
import time

import numpy as np

import fretwork as fw

PALETTE = ["0-1+1-6", "0-5+5-6", "0-1+1-5+1-6+5-6"]


def import_seconds():
    code = "import time; t = time.perf_counter(); import fretwork; print(time.perf_counter() - t)"
    return statistics.median(float(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout)
                             for _ in range(9))


def case_of(tiles):
    side = 0.025 * 1.6 * tiles**0.5
    square = fw.make_outline([[0, 0], [side, 0], [side, side], [0, side]])
    project, report = fw.make_project(square, "random:1", palette=PALETTE, edge_length=0.025)
    case = fw.LoadCase(name="tip", supports=[fw.LoadCase.Support(fw.NodesAtSide("left"), "all")],
                       loads=[fw.LoadCase.Load(fw.NodesAtSide("right"), force=[0, 0, -1e-4])])
    return fw.make_surface(project), case, report.tiles


def edits(model, count=1000):
    """Seconds of so many repaints, of the solutions after them, and of these what C++ took by its own clock."""
    surface, case, tiles = case_of(100)
    session = fw.Session(surface, case, model=model, threads=1)
    session.solve()
    painting = solving = inside = 0.0
    for edit in range(count):
        started = time.perf_counter()
        session.paint([edit % tiles], PALETTE[(edit // tiles + edit) % 3])
        painted = time.perf_counter()
        inside += session.solve().seconds
        painting += painted - started
        solving += time.perf_counter() - painted
    return painting, solving, inside, tiles


def library_seconds():
    """All patterns of the paper's layout with 50 samples of six nodes each."""
    layout, setting = fw.paper_layout(), fw.paper_setting()
    patterns = fw.enumerate_patterns(layout)
    responses = fw.compute_responses(layout, patterns[0], setting)
    with tempfile.TemporaryDirectory() as folder:
        with fw.Library.create(folder + "/all.db", layout, setting) as library:
            library.add_patterns(patterns)
            library.store([fw.PatternData(fw.pattern_id(layout, one), responses) for one in patterns])
            started, used = time.perf_counter(), time.process_time()
            arrays = library.response_arrays()
            return time.perf_counter() - started, time.process_time() - used, arrays.converged.size


def gradient_share():
    surface, case, tiles = case_of(500)
    session = fw.Session(surface, case, model="corotational", threads=1)
    started = time.perf_counter()
    result = session.solve()
    solution = time.perf_counter() - started
    gradient = np.zeros_like(result.displacements)
    gradient[:, 2] = 1.0
    session.sensitivity(gradient)
    started = time.perf_counter()
    session.sensitivity(gradient)
    return (time.perf_counter() - started) / solution, tiles


def stop_seconds():
    """From SIGINT to KeyboardInterrupt, the longest of ten."""
    layout, longest = fw.find_node_layout("fifths12"), 0.0
    for _ in range(10):
        sent = []

        def interrupt():
            time.sleep(0.2)
            sent.append(time.perf_counter())
            os.kill(os.getpid(), signal.SIGINT)

        threading.Thread(target=interrupt).start()
        try:
            fw.count_patterns(layout)
        except KeyboardInterrupt:
            longest = max(longest, time.perf_counter() - sent[0])
    return longest


def main():
    print(f"import: {import_seconds():.3f} s")
    for model in ("condensed", "corotational"):
        painting, solving, inside, tiles = edits(model)
        print(f"1,000 edits of {tiles} tiles, {model}: painting {painting:.2f} s, solving {solving:.2f} s, "
              f"{solving / inside:.3f} of what C++ took")
    seconds, processor_seconds, states = library_seconds()
    print(f"library: {states} states in {seconds:.2f} s, {processor_seconds:.2f} s of processor time")
    share, tiles = gradient_share()
    print(f"gradient of {tiles} tiles: {share:.2f} of its solution")
    print(f"Ctrl-C: {1e3 * stop_seconds():.0f} ms at most")


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which ranking of tiles finds those that are best put in full (what `mixed:0.05` does).

Usage: rankings.py PROGRAM PATTERNS OUT --rankings FILE [--count N] [--seed N]   (PATTERNS: ids, one a line; FILE: the program
large_deflection_rankings). The surfaces are the cantilevers and bridges of run.py. Rows go to OUT/rankings.csv: mean errors
over the largest displacement. A table is printed.
"""
import json
import statistics
import subprocess

import run
from csv_tables import GrowingTable, print_table

RANKINGS = ("corotational", "energy_rotation", "energy", "rotation", "energy2_rotation")
KINDS = ("cantilever", "bridge")
BOUND = 0.004
LARGE = 0.001  # where the choice matters
DIGITS = 4


def errors_of(program, folder):
    done = subprocess.run([program, "project.json", "case.json"], cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        raise run.Failed([program], done.stderr.strip())
    return json.loads(done.stdout)


def line(name, rows):
    values = sorted(row[name] for row in rows)
    above = sum(value > BOUND for value in values)
    best = sum(row[name] <= 1.05 * min(row[other] for other in RANKINGS) for row in rows if row["corotational"] > LARGE)
    return [name, *(f"{100 * value:.2g}" for value in (statistics.median(values), values[round(0.9 * (len(values) - 1))], values[-1])), above, best]


def main():
    study = run.Study(__doc__, lambda parser: parser.add_argument("--rankings", required=True))
    rows = []
    table = GrowingTable.anew(study.out / "rankings.csv", DIGITS, ["number", "kind", *RANKINGS])
    for surface in study.surfaces:
        if surface["kind"] not in KINDS:
            continue
        run.make_surface(study.fretwork, surface, study.patterns)
        row = {"number": surface["number"], "kind": surface["kind"], **errors_of(study.options.rankings, study.folder)}
        table.add([row])
        rows.append(row)
    matters = sum(row["corotational"] > LARGE for row in rows)
    header = [f"ranked by ({len(rows)} surfaces)", "median, %", "90 % below", "most", f"above {100 * BOUND:g} %", f"within 5 % of the best, of {matters}"]
    print_table(header, [line(name, rows) for name in RANKINGS])


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How well linear solutions know that they are out of their range.

Usage: linear_range.py PROGRAM PATTERNS OUT [--count N] [--seed N]   (PATTERNS: ids, one a line)
The surfaces are those of run.py, each under a tenth, three tenths and all of its load. Rows go to OUT/linear_range.csv: the
estimate of `simulate --model condensed`, and the largest error of the condensed and the full linear model against the full
one, as shares of the largest displacement. A summary is printed.
"""
import json

import run
from csv_tables import GrowingTable
from surface import errors

SHARES = (0.1, 0.3, 1.0)
FIELDS = ["number", "kind", "share", "estimate", "loses_stability", "is_exceeded", "error", "full_is_unstable", "note"]
IN_RANGE = 0.05
DIGITS = 10


def scaled(case, share):
    for load in case.get("loads", []):
        for key in ("force", "moment"):
            if key in load:
                load[key] = [share * value for value in load[key]]
    for entry in case.get("prescribed", []):
        entry["uz"] *= share
    if "gravity" in case:
        case["gravity"] = [share * value for value in case["gravity"]]
    return case


def rows_of(fretwork, surface, patterns):
    run.make_surface(fretwork, surface, patterns)
    whole = json.loads((fretwork.folder / "case.json").read_text())
    for share in SHARES:
        fretwork.write("case.json", scaled(json.loads(json.dumps(whole)), share))
        row = {"number": surface["number"], "kind": surface["kind"], "share": share}
        try:
            told = fretwork.simulate("condensed")["linear_range"]
            row.update(estimate=told["error_estimate"], loses_stability=told["loses_stability"], is_exceeded=told["is_exceeded"])
            fretwork.simulate("full")
            compared = fretwork.compare("full", "condensed")
            row.update(error=errors(compared)["largest"], full_is_unstable=compared["full_is_unstable"])
        except run.Failed as failure:
            row["note"] = failure.told
        yield row


def summary(rows):
    known = [row for row in rows if not row.get("note")]
    wrong = [row for row in known if row["error"] > IN_RANGE or row["full_is_unstable"]]
    right = [row for row in known if row not in wrong]
    told = [row for row in wrong if row["is_exceeded"]]
    false = [row for row in right if row["is_exceeded"]]
    near = [row for row in known if not row["full_is_unstable"] and 0.5 <= row["estimate"] / max(row["error"], 1e-12) <= 2]
    print(f"{len(known)} solutions with a full one beside them; {len(rows) - len(known)} without")
    print(f"out of range (error above {IN_RANGE:.0%}, or the full model unstable): {len(wrong)}, of which told {len(told)}")
    print(f"in range: {len(right)}, of which told nevertheless {len(false)}")
    print(f"estimate within a factor of two of the error: {len(near)}")
    for row in wrong:
        if not row["is_exceeded"]:
            print(f"  not told: {row['number']} {row['kind']} at {row['share']}: estimate {row['estimate']:.3f}, error {row['error']:.3f}")


def main():
    study = run.Study(__doc__)
    rows = []
    table = GrowingTable.anew(study.out / "linear_range.csv", DIGITS, FIELDS)
    for surface in study.surfaces:
        try:
            found = list(rows_of(study.fretwork, surface, study.patterns))
        except run.Failed as failure:
            found = [{"number": surface["number"], "kind": surface["kind"], "note": failure.told}]
        table.add(found)
        rows += found
    summary(rows)


if __name__ == "__main__":
    main()

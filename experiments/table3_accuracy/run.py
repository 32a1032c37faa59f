#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Three shapes of the sizes of the paper's examples, each in three random paintings, with the full model and with reduced ones.

The loads of the cases are scaled so that each surface is bent as far as the paper's.

Usage: run.py PROGRAM OUT [--relaxation]   (--relaxation: the full model also by dynamic relaxation, as published; hours)
Rows go to OUT/table3.csv. The library of 24 patterns, OUT/table3.db, is kept if it is there.
"""
import argparse
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "common"))
from csv_tables import read_rows, write_rows  # noqa: E402
from program import Fretwork  # noqa: E402

CASES = {"A": "bridge", "B": "example_b", "C": "example_c"}
PAINTINGS = (1, 2, 3)
MOST_TRIALS = 12
NOT_CONVERGED = 1  # the exit code; results are printed all the same
DIGITS = 6  # of the numbers in the tables
MODELS = ("paper6", "condensed", "corotational", "mixed:0.05", "full linear")
HERE = pathlib.Path(__file__).resolve().parent


def fill_library(fretwork):
    if not (fretwork.folder / "table3.db").exists():
        fretwork("enumerate", "--layout", "paper7", "--library", "table3.db")
    fretwork("calibrate", "--library", "table3.db", "--patterns", "sample:24")


def result_file(name, model):
    return f"{name}_{model.replace(':', '-').replace(' ', '-')}.json"


def simulate(fretwork, name, case, model):
    name_of_model, *linear = model.split()
    options = ["--linear"] if linear else []
    told = fretwork("simulate", f"{name}.json", "--case", case, "--model", name_of_model, *options, "--out",
                    result_file(name, model), "--json")
    return json.loads(told)


def published_deflection(example):
    return next(float(row["max_displacement_m"]) for row in read_rows(HERE / "published.csv") if row["example"] == example)


def scaled_case(fretwork, example, factor):
    """The example's load case with its forces times a factor."""
    case = json.loads((HERE.parent / "cases" / f"{CASES[example]}.json").read_text())
    for load in case["loads"]:
        load["force"] = [factor * component for component in load["force"]]
    (fretwork.folder / f"case_{example}.json").write_text(json.dumps(case))
    return f"./case_{example}.json"


def case_as_published(fretwork, example, name):
    """Scale the load until the surface moves as far as the paper's: within a hundredth, by the corotational model."""
    wanted = published_deflection(example)
    factor = 1.0
    for _ in range(MOST_TRIALS):
        case = scaled_case(fretwork, example, factor)
        told = simulate(fretwork, name, case, "corotational")
        found = told["largest_displacement"] / wanted
        if abs(found - 1.0) < 0.01:
            break
        factor /= found
    return case


def rows_of(fretwork, example, painting):
    name = f"{example.lower()}{painting}"
    fretwork("tile", HERE.parent / "outlines" / f"example_{example.lower()}.svg", "--patterns", f"random:{painting}", "--library",
             "table3.db", "--out", f"{name}.json")
    case = case_as_published(fretwork, example, name)
    simulate(fretwork, name, case, "full")
    for model in MODELS:
        simulate(fretwork, name, case, model)
        compared = json.loads(fretwork("compare", result_file(name, "full"), result_file(name, model), "--json"))
        yield {**compared, "example": example, "painting": painting, "model": model}


def relaxation_seconds(fretwork, example):
    """The full model of the first painting by dynamic relaxation."""
    name = f"{example.lower()}{PAINTINGS[0]}"
    case = case_as_published(fretwork, example, name)
    fretwork("simulate", f"{name}.json", "--case", case, "--model", "full", "--out", "full.json", "--frame-out", "frame.json")
    told = json.loads(fretwork("solve", "frame.json", "--solver", "dynamic-relaxation", "--out", "relaxed.json", "--json",
                               accepted=(0, NOT_CONVERGED)))
    newton = json.loads((fretwork.folder / "full.json").read_text())["seconds"]
    return {"example": example, "newton_seconds": newton, "relaxation_seconds": told["seconds"],
            "iterations": told["iterations"], "converged": told["converged"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--relaxation", action="store_true")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    fretwork = Fretwork(options.program.resolve(), options.out)
    fill_library(fretwork)
    rows = [row for example in CASES for painting in PAINTINGS for row in rows_of(fretwork, example, painting)]
    write_rows(options.out / "table3.csv", rows, DIGITS)
    if options.relaxation:
        write_rows(options.out / "relaxation.csv", [relaxation_seconds(fretwork, example) for example in CASES], DIGITS)


if __name__ == "__main__":
    main()

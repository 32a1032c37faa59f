#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""From the rows of run.py: "item | paper | ours | verdict", or with --page the tables of README.md.

Usage: tables.py TABLE3.csv [--page]
"""
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "common"))
from csv_tables import read_rows  # noqa: E402

MODELS = ("paper6", "condensed", "full linear", "corotational", "mixed:0.05")
SECONDS = ("full_model_seconds", "full_model_minutes", "reduced_model_seconds", "reduced_model_milliseconds")
PAPERS_MODEL = "paper6"
SAME_SIZE = 2.0  # errors that differ by at most this factor are of the same size
QUANTITIES = {"displacement": ("max_translation_error_m", "max_displacement_m"),
              "rotation": ("max_rotation_error_rad", "max_rotation_rad")}
NUMBERS = {*SECONDS, *(column for columns in QUANTITIES.values() for column in columns)}  # other columns stay texts


def read(path):
    return [{key: float(value) if key in NUMBERS else value for key, value in row.items()} for row in read_rows(path)]


def share(row, quantity):
    error, largest = QUANTITIES[quantity]
    return row[error] / row[largest]


def spread(values):
    return f"{min(values):.2g} to {max(values):.2g}"


def shares(rows, example, model, quantity):
    return [share(row, quantity) for row in rows if row["example"] == example and row["model"] == model]


def verdict(theirs, ours):
    """How the errors of our paintings compare with the paper's; shapes and loads are our own."""
    if all(theirs / SAME_SIZE <= share_of_ours <= theirs * SAME_SIZE for share_of_ours in ours):
        return "same size of error; own shape and loads"
    word = "larger" if max(ours) > theirs * SAME_SIZE else "smaller"
    return f"{word}: {spread([share_of_ours / theirs for share_of_ours in ours])} times; own shape and loads"


def print_items(rows, published):
    print("item | paper | ours: least to most of three paintings | verdict")
    for paper in published:
        for model in MODELS:
            for quantity in QUANTITIES:
                found = shares(rows, paper["example"], model, quantity)
                theirs, judged = "-", "not in the paper"
                if model == PAPERS_MODEL:
                    theirs, judged = f"{share(paper, quantity):.2g}", verdict(share(paper, quantity), found)
                print(f"Example {paper['example']}, {model}, largest error / largest {quantity} | {theirs} | {spread(found)} | {judged}")


def print_page(rows, published):
    for quantity in QUANTITIES:
        print(f"| example | largest {quantity} | the paper's model in the paper | {' | '.join(MODELS)} |")
        print("|---|---|---|" + "---|" * len(MODELS))
        for paper in published:
            example = paper["example"]
            largest = [row[QUANTITIES[quantity][1]] for row in rows if row["example"] == example]
            scale, unit = (1e3, "mm") if quantity == "displacement" else (57.29578, "deg")
            sizes = f"{scale * min(largest):.0f} to {scale * max(largest):.0f} {unit} (paper {scale * paper[QUANTITIES[quantity][1]]:.0f})"
            cells = [spread([100 * value for value in shares(rows, example, model, quantity)]) for model in MODELS]
            print(f"| {example} | {sizes} | {100 * share(paper, quantity):.2g} | {' | '.join(cells)} |")
        print()
    print(f"| example | full, s | {', s | '.join(MODELS)}, s | paper: full, minutes / reduced, s |")
    print("|---|---|" + "---|" * len(MODELS) + "---|")
    for paper in published:
        own = [row for row in rows if row["example"] == paper["example"]]
        full = spread([row["full_model_seconds"] for row in own])
        cells = [spread([row["reduced_model_seconds"] for row in own if row["model"] == model]) for model in MODELS]
        print(f"| {paper['example']} | {full} | {' | '.join(cells)} | "
              f"{paper['full_model_minutes']:.2g} / {paper['reduced_model_milliseconds'] / 1e3:.2g} |")


def main():
    rows, published = read(sys.argv[1]), read(HERE / "published.csv")
    (print_page if "--page" in sys.argv else print_items)(rows, published)


if __name__ == "__main__":
    main()

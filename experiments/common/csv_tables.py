# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables: read and written as CSV, and printed for a README."""
import csv


def read_rows(path):
    """The rows of a file as dictionaries of texts."""
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def with_numbers(rows, *texts):
    """The rows with floats for texts, except in the columns `texts` and in empty cells."""
    return [{key: value if key in texts or value == "" else float(value) for key, value in row.items()} for row in rows]


def write_rows(path, rows, digits):
    """Write rows with the columns of the first row, and floats with this number of significant digits."""
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows({key: f"{value:.{digits}g}" if isinstance(value, float) else value for key, value in row.items()} for row in rows)


def print_table(header, lines):
    """Print a table in Markdown, followed by an empty line."""
    print("| " + " | ".join(header) + " |\n|" + "---|" * len(header))
    for line in lines:
        print("| " + " | ".join(map(str, line)) + " |")
    print()


def percent(share):
    """A share in percent: two digits below 10 %, whole numbers above."""
    return f"{100 * share:.2g}" if share < 0.1 else f"{100 * share:.0f}"

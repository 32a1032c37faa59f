# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables: read and written as CSV, and printed for a README."""
import csv
import gzip

csv.field_size_limit(2**30)  # traces of long runs of optimizers are longer than the default allows


def each_row(path):
    """The rows of a file one after another, as dictionaries of texts. A file whose name ends in .gz is unpacked."""
    with gzip.open(path, "rt", newline="") if str(path).endswith(".gz") else open(path, newline="") as file:
        yield from csv.DictReader(file)


def columns_of(path):
    """The names in the first line of a file."""
    with open(path, newline="") as file:
        return next(csv.reader(file))


def read_rows(path):
    """All rows of a file, as each_row gives them."""
    return list(each_row(path))


def with_numbers(rows, *texts):
    """The rows with floats for texts, except in the columns `texts` and in empty cells."""
    return [{key: value if key in texts or value == "" else float(value) for key, value in row.items()} for row in rows]


def rounded(row, digits):
    """The row with its floats as texts of this number of significant digits."""
    return {key: f"{value:.{digits}g}" if isinstance(value, float) else value for key, value in row.items()}


def write_rows(path, rows, digits):
    """Write rows with the columns of the first row, and floats with this number of significant digits."""
    write_table(path, list(rows[0]), (rounded(row, digits).values() for row in rows))


def write_table(path, columns, lines):
    """Write lists of cells below the names of their columns. Cells are written as str() has them: floats to the last bit."""
    with open(path, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows(lines)


class GrowingTable:
    """A table that a long run writes as its rows come. A run that begins again finds the rows of the earlier one in `rows`.

    Its columns are those given, or those of the first row that is added.
    """

    def __init__(self, path, digits, columns=None):
        self.path, self.columns, self.digits = path, columns, digits
        self.rows = read_rows(path) if path.exists() else []

    @classmethod
    def anew(cls, path, digits, columns=None):
        """Without the rows of an earlier run."""
        path.unlink(missing_ok=True)
        return cls(path, digits, columns)

    def add(self, rows):
        """Write rows to the end of the file. Cells that a row lacks are empty."""
        with open(self.path, "a", newline="") as file:
            self.columns = self.columns or list(rows[0])
            writer = csv.DictWriter(file, self.columns, restval="", lineterminator="\n")
            if file.tell() == 0:
                writer.writeheader()
            writer.writerows(rounded(row, self.digits) for row in rows)


def print_table(header, lines):
    """Print a table in Markdown, followed by an empty line."""
    print("| " + " | ".join(header) + " |\n|" + "---|" * len(header))
    for line in lines:
        print("| " + " | ".join(map(str, line)) + " |")
    print()


def percent(share):
    """A share in percent: two digits below 10 %, whole numbers above."""
    return f"{100 * share:.2g}" if share < 0.1 else f"{100 * share:.0f}"

# SPDX-License-Identifier: GPL-3.0-or-later
"""Do the tables of the experiments' pages follow from the commands that print them?

Usage: pages.py BUILD [--slow] [--only EXPERIMENT ..]

A table that follows from a command says so above itself:
    <!-- printed by: analyse.py rows.csv OUT/figure.svg -->           takes seconds: make check runs it
    <!-- printed slowly by: run.sh PROGRAM OUT; varies: CPU ms -->    takes longer: make soak runs it (--slow)
The command runs in the page's folder. BUILD is the folder of the build, PROGRAM the command line's program in it, OUT a folder of this
run (out/pages/EXPERIMENT). Every row of the table has to be among the rows that the command prints: the same entries behind the first
one, which is a name, or the same numbers in them. The columns behind `varies:`, such as times, are not compared.
Prints a line for each command. Exit code 1: a row does not follow, or a command failed."""
import argparse
import pathlib
import re
import subprocess
import sys

EXPERIMENTS = pathlib.Path(__file__).resolve().parents[1]
MARKER = re.compile(r"<!-- printed (slowly )?by: (.+?)(?:; varies: (.+?))? -->")
NUMBER = re.compile(r"[-+]?\d[\d,]*(?:\.\d+)?(?:e[-+]?\d+)?")
RULE = re.compile(r"[|:\- ]+")


def entries(line):
    return [" ".join(cell.replace("`", "").replace("**", "").split()) for cell in line.strip().strip("|").split("|")]


def numbers(cells):
    return [float(number.replace(",", "")) for cell in cells for number in NUMBER.findall(cell)]


def rows(text):
    """The rows of all tables of a text."""
    return [entries(line) for line in text.splitlines() if line.lstrip().startswith("|") and not RULE.fullmatch(line.strip())]


class Table:
    """A table of a page: its header, its rows, and the commands that print it."""

    def __init__(self, markers, lines):
        self.header, *self.rows = rows("\n".join(lines))
        self.commands = [(bool(slow), command, [name.strip() for name in varies.split(",")] if varies else []) for slow, command, varies in markers]

    def missing(self, printed, varies):
        """The rows that are not among the printed ones."""
        unknown = set(varies) - set(self.header)
        if unknown:
            raise SystemExit(f"pages.py: there is no column '{unknown.pop()}' in the table with {' | '.join(self.header)}")
        left_out = {self.header.index(name) for name in varies}

        def behind_the_name(row):
            return [cell for column, cell in enumerate(row) if column > 0 and column not in left_out]

        candidates = [behind_the_name(row) for row in printed]
        return [row for row in self.rows if not any(agree(behind_the_name(row), other) for other in candidates)]


def agree(own, other):
    return own == other or (numbers(own) != [] and numbers(own) == numbers(other))


def tables(page):
    """The tables of a page's text, in their order."""
    found, markers, lines = [], [], []
    for line in [*page.splitlines(), ""]:
        if line.startswith("|"):
            lines.append(line)
            continue
        if lines:
            found.append(Table(markers, lines))
            markers, lines = [], []
        marker = MARKER.fullmatch(line.strip())
        if marker:
            markers.append(marker.groups())
        elif line.strip():
            markers = []
    return found


def run(command, folder, build):
    """What a command prints. Scripts of Python run by Debian's, which has NumPy and SciPy."""
    out = build.resolve().parents[1] / "out" / "pages" / folder.name
    out.mkdir(parents=True, exist_ok=True)
    words = {"BUILD": build, "PROGRAM": build / "apps" / "fretwork" / "fretwork", "OUT": out}
    arguments = [re.sub(r"\b(BUILD|PROGRAM|OUT)\b", lambda word: str(words[word[0]]), word) for word in command.split()]
    script = folder / arguments[0]
    start = ["/usr/bin/python3", "-B", str(script)] if script.suffix == ".py" else [str(script)]
    done = subprocess.run([*start, *arguments[1:]], cwd=folder, capture_output=True, text=True)
    return done.returncode, done.stdout, (done.stderr.strip().splitlines() or [""])[-1]


def check(page, slow, build):
    """Compare a page with the commands that its tables name, and give the number of faults."""
    name = page.parent.name if page.name == "README.md" else f"{page.parent.name}/{page.name}"
    found = tables(page.read_text())
    wanted = {command: None for table in found for is_slow, command, _ in table.commands if is_slow == slow}
    faults = 0
    for command in wanted:
        code, printed, complaint = run(command, page.parent, build)
        if code != 0:
            print(f"{name}: {command}: exit code {code}: {complaint}")
            faults += 1
            continue
        of_command = [(table, varies) for table in found for is_slow, other, varies in table.commands if other == command and is_slow == slow]
        missing = [row for table, varies in of_command for row in table.missing(rows(printed), varies)]
        for row in missing:
            print(f"{name}: not printed by {command}: | {' | '.join(row)} |")
        print(f"{name}: {command}: {len(of_command)} tables, {sum(len(table.rows) for table, _ in of_command)} rows, {len(missing)} differ")
        faults += len(missing)
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--slow", action="store_true")
    parser.add_argument("--only", nargs="+", default=[])
    options = parser.parse_args()
    pages = [page for page in sorted(EXPERIMENTS.glob("*/*.md")) if not options.only or page.parent.name in options.only]
    faults = sum([check(page, options.slow, options.build.resolve()) for page in pages])
    unmarked = sum(not table.commands for page in pages for table in tables(page.read_text()))
    print(f"{unmarked} tables of these pages name no command that prints them")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

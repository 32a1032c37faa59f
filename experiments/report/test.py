#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The report of a small made-up run. Usage: test.py PROGRAM"""
import hashlib
import html
import html.parser
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import report  # noqa: E402

PROGRAM = sys.argv.pop(1) if len(sys.argv) > 1 else ""


def make_run(folder):
    for name, _, files in report.TABLES:
        (folder / f"{name}.rows").write_text(f"item | paper | ours | verdict\n{name} <i> | 1,2 | 1.25 | equal\nb | 2 | 3.5 | DIFFERS\n")
        for file in files:
            (folder / file).write_text(name)
    for name, *_ in report.FIGURES:
        (folder / f"{name}.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg" data-print-width="84mm"/>')


def run(folder):
    return subprocess.run([sys.executable, str(HERE / "report.py"), PROGRAM, str(folder), str(folder), str(folder / "r.html")],
                          capture_output=True, text=True, check=False)


class Cells(html.parser.HTMLParser):
    """The texts of all cells of tables."""

    def __init__(self):
        super().__init__()
        self.cells, self.inside = [], False

    def handle_starttag(self, tag, attrs):
        if tag == "wbr":  # a place where a long row may break
            return
        self.inside = tag == "td"
        if self.inside:
            self.cells.append("")

    def handle_data(self, data):
        if self.inside:
            self.cells[-1] += data.strip()


class Report(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)
        make_run(self.folder)

    def test_has_every_row_and_hash_of_the_run(self):
        self.assertEqual(run(self.folder).returncode, 0)
        text = (self.folder / "r.html").read_text()
        cells = Cells()
        cells.feed(text)
        expected = []
        for name, _, files in report.TABLES:
            expected += [f"{name} <i>", "1,2", "1.25", "equal", "b", "2", "3.5", "DIFFERS"]
            for file in files:
                self.assertIn(hashlib.sha256((self.folder / file).read_bytes()).hexdigest(), text)
        self.assertEqual(cells.cells, expected)
        self.assertIn(f"<b>{len(report.TABLES)}</b> that differ", text)
        self.assertEqual(len(re.findall("<figcaption>", text)), len(report.FIGURES))
        for _, figure, paper, ours in report.FIGURES:
            self.assertIn(f"<b>{figure}.</b> <i>The paper's:</i> {html.escape(paper)}. <i>Ours</i> (84 mm wide in print)<i>:</i> {html.escape(ours)}.", text)

    def test_figures_are_as_wide_beside_each_other_as_in_print(self):
        (self.folder / "fig02.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg" data-print-width="177mm"/>')
        run(self.folder)
        text = (self.folder / "r.html").read_text()
        self.assertEqual(re.findall(r'<img style="width:(\d+)%"', text), ["100"] + ["47"] * (len(report.FIGURES) - 1))

    def test_loads_nothing_from_elsewhere(self):
        run(self.folder)
        text = (self.folder / "r.html").read_text()
        self.assertEqual(re.findall(r'(?:src|href)="(?!data:)', text), [])
        self.assertNotIn("http", text)
        self.assertIn("prefers-color-scheme: dark", text)

    def test_is_the_same_for_the_same_run(self):
        run(self.folder)
        first = (self.folder / "r.html").read_bytes()
        run(self.folder)
        self.assertEqual((self.folder / "r.html").read_bytes(), first)

    def test_refuses_a_run_that_is_not_whole(self):
        for broken, said in (("table1_enumeration.rows", "is missing"), ("table3.csv", "is missing"), ("fig10.svg", "is missing")):
            make_run(self.folder)
            (self.folder / broken).unlink()
            done = run(self.folder)
            self.assertEqual(done.returncode, 2, broken)
            self.assertIn(f"{broken}: {said}", done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1)
            self.assertFalse((self.folder / "r.html").exists())

    def test_names_the_line_of_a_row_that_is_not_valid(self):
        (self.folder / "table3_accuracy.rows").write_text("item | paper | ours | verdict\na | 1\n")
        done = run(self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("table3_accuracy.rows: line 2: has 2 columns", done.stderr)


if __name__ == "__main__":
    unittest.main()

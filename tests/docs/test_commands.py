# SPDX-License-Identifier: GPL-3.0-or-later
"""Every command and every program on a page runs, and prints what the page says.

Above a block of a page stands a comment that says what becomes of it:

- `<!-- run -->` before `sh`: it is run, in a new folder for each page, with `experiments` beside it; `<!-- run slow -->`: by `make check` alone.
- `<!-- setup` .. `-->`: commands that a reader has no use for, run before what follows.
- `<!-- prints -->` before `text`: lines of what the block before it prints. `..` stands for what may differ.
- `<!-- no run: why -->` before `sh` or `python`: it is not run, for that reason.

- `<!-- tour -->` and `<!-- program -->` of README.md are run by tests/cli and tests/install, `<!-- compiled -->` by tests/readmes, `<!-- query -->` by tests/library.

Other blocks of `json` have to be read by the program if they have a format; `python` runs where the module is built, `cpp` after `<!-- program -->` is compiled
and run by the build (CMakeLists.txt), and `sql` is run against the page's library.
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import support
from support import markdown

PACKAGE = os.environ.get("FRETWORK_PACKAGE")


def environment():
    path = f"{support.PROGRAM.parent}:{os.environ['PATH']}"
    return os.environ | {"PATH": path, "PYTHONPATH": PACKAGE or "", "PYTHONDONTWRITEBYTECODE": "1", "FRETWORK": str(support.PROGRAM)}


def run(command, folder):
    """What a command prints on both streams, in order, and its exit code."""
    got = subprocess.run(command, cwd=folder, env=environment(), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, stdin=subprocess.DEVNULL)
    return got.stdout, got.returncode


def is_line(wanted, line):
    """Whether a line is the one that a page shows: spaces are alike, and `..` is anything."""
    pattern = ".*".join(re.escape(" ".join(part.split())) for part in wanted.split(".."))
    return re.fullmatch(re.sub(r"(\\ )?\.\*(\\ )?", ".*", pattern), " ".join(line.split())) is not None


class Page:
    """A page's blocks, run one after the other."""

    def __init__(self, test, page, folder):
        self.test, self.page, self.folder, self.printed = test, page, folder, ""
        (folder / "experiments").symlink_to(support.SOURCE / "experiments")
        (folder / "docs").symlink_to(support.SOURCE / "docs")

    def place(self, block):
        return f"{self.page.relative_to(support.SOURCE)}:{block.line}"

    def run_all(self):
        blocks = markdown.blocks(self.page.read_text())
        if not support.IS_SLOW and any(block.mark == "run slow" for block in blocks):
            blocks = blocks[:next(i for i, block in enumerate(blocks) if block.mark == "run slow")]
        for block in blocks:
            with self.test.subTest(self.place(block)):
                self.run_block(block)

    def run_block(self, block):
        if block.mark in ("run", "run slow", "setup"):
            self.printed, code = run(["bash", "-euo", "pipefail", "-c", block.text], self.folder)
            self.test.assertEqual(code, 0, f"{self.place(block)}\n{block.text}\n{self.printed}")
        elif block.mark == "prints":
            self.check_lines(block)
        elif block.language == "python" and not block.mark and PACKAGE:
            self.printed, code = run([sys.executable, "-c", block.text], self.folder)
            self.test.assertEqual(code, 0, f"{self.place(block)}\n{self.printed}")
        elif block.language == "json":
            self.check_json(block)

    def check_lines(self, block):
        lines = self.printed.split("\n")
        for wanted in filter(str.strip, block.text.split("\n")):
            self.test.assertTrue(any(is_line(wanted, line) for line in lines), f"{self.place(block)}: no line like\n{wanted}\n-- in --\n{self.printed}")

    def check_json(self, block):
        if not json.loads(block.text).get("format"):
            return
        with tempfile.NamedTemporaryFile("w", suffix=".json", dir=self.folder) as file:
            file.write(block.text)
            file.flush()
            printed, code = run([str(support.PROGRAM), "check", file.name], self.folder)
            self.test.assertEqual(code, 0, f"{self.place(block)}\n{printed}")


class Commands(unittest.TestCase):
    def test_what_pages_show_runs(self):
        count = 0
        for page in support.pages():
            blocks = markdown.blocks(page.read_text())
            if any(block.mark or block.language in ("python", "json") for block in blocks):
                count += 1
                with tempfile.TemporaryDirectory() as folder:
                    Page(self, page, pathlib.Path(folder)).run_all()
        self.assertGreater(count, 10)

    def test_every_block_says_what_becomes_of_it(self):
        known = {"sh": {"run", "run slow", "tour"}, "cpp": {"program", "compiled"}, "sql": {"query"}}
        for page in support.pages():
            for block in markdown.blocks(page.read_text()):
                if block.language in known and not block.mark.startswith("no run: ") and block.mark != "setup":
                    self.assertIn(block.mark, known[block.language], f"{page.relative_to(support.SOURCE)}:{block.line}")
                self.assertNotEqual(block.language, "", f"{page.relative_to(support.SOURCE)}:{block.line}: a block without a language")


if __name__ == "__main__":
    unittest.main()

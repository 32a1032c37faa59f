# SPDX-License-Identifier: GPL-3.0-or-later
"""pages.py finds a row that its command does not print."""
import contextlib
import io
import pathlib
import tempfile
import unittest

import pages

PAGE = """# A page

<!-- printed by: print.sh -->
| model | error | seconds |
|---|---|---|
| **`full`** | 1,200 mm (1e-3) | 3 |
| paper6 | 0.5 | |

| no | command |
|---|---|
| 1 | 2 |
"""
PRINTED = """| kind | error | seconds |
|---|---|---|
| all beams | 1200 mm (1e-3) | 3 |
| paper6 | 0.5 | |
"""


class Pages(unittest.TestCase):
    def faults(self, page, printed, slow=False):
        with tempfile.TemporaryDirectory() as name, contextlib.redirect_stdout(io.StringIO()):
            folder = pathlib.Path(name) / "experiment"
            folder.mkdir()
            script = folder / "print.sh"
            script.write_text(f"#!/bin/sh\ncat <<'END'\n{printed}END\n")
            script.chmod(0o755)
            (folder / "README.md").write_text(page)
            return pages.check(folder / "README.md", slow, pathlib.Path(name) / "build" / "release")

    def test_rows_follow_from_what_is_printed_whatever_they_are_called(self):
        self.assertEqual(self.faults(PAGE, PRINTED), 0)

    def test_a_number_that_differs_is_found(self):
        self.assertEqual(self.faults(PAGE, PRINTED.replace("0.5", "0.6")), 1)

    def test_a_row_that_is_not_printed_is_found(self):
        self.assertEqual(self.faults(PAGE, PRINTED.replace("| paper6 | 0.5 | |\n", "")), 1)

    def test_columns_that_vary_are_not_compared(self):
        varies = PAGE.replace("print.sh -->", "print.sh; varies: seconds -->")
        self.assertEqual(self.faults(varies, PRINTED.replace("| 3 |", "| 4 |")), 0)
        self.assertEqual(self.faults(PAGE, PRINTED.replace("| 3 |", "| 4 |")), 1)

    def test_a_command_that_fails_is_a_fault(self):
        self.assertEqual(self.faults(PAGE, PRINTED + "END\nexit 3\ncat <<'END'\n"), 1)

    def test_slow_commands_run_only_when_asked_for(self):
        slow = PAGE.replace("printed by", "printed slowly by")
        self.assertEqual(self.faults(slow, ""), 0)
        self.assertEqual(self.faults(slow, "", slow=True), 2)


if __name__ == "__main__":
    unittest.main()

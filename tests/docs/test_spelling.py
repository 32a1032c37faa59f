# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages, comments and messages are spelled right, as far as codespell knows."""

import shutil
import subprocess
import unittest

import support

WORDS = "gere,lenght,siez,statics,wieght"  # a name, a field, and mistakes that tests make on purpose


class Spelling(unittest.TestCase):
    @unittest.skipUnless(shutil.which("codespell"), "there is no codespell")
    def test_words_are_spelled_right(self):
        folders = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "third_party_notes.md", "docs", "framework", "apps", "experiments", "tests", "bench", "scripts", "cmake"]
        command = ["codespell", "--ignore-words-list", WORDS, "--skip", "*.svg,*.png,*.csv,*.gz,*.json,*.ipynb,*.bib,node_modules,dist", *folders]
        got = subprocess.run(command, cwd=support.SOURCE, text=True, capture_output=True)
        self.assertEqual(got.stdout, "")
        self.assertEqual(got.returncode, 0, got.stderr)


if __name__ == "__main__":
    unittest.main()

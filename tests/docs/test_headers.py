# SPDX-License-Identifier: GPL-3.0-or-later
"""Every symbol of a public header says what it is. Needs Doxygen."""

import pathlib
import tempfile
import unittest

import support


class Headers(unittest.TestCase):
    def test_every_public_symbol_has_a_comment(self):
        import cpp_headers
        with tempfile.TemporaryDirectory() as folder:
            symbols = cpp_headers.read_headers(support.SOURCE / "framework/fretwork", pathlib.Path(folder))
        self.assertGreater(sum(len(found) for found in symbols.values()), 600)
        silent = cpp_headers.undocumented(symbols)
        self.assertEqual(silent, [], f"{len(silent)} symbols without a comment")


if __name__ == "__main__":
    unittest.main()

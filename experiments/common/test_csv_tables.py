#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables are read as they were written."""
import gzip
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from csv_tables import GrowingTable, columns_of, read_rows, write_rows, write_table  # noqa: E402


class Tables(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "rows.csv"

    def test_floats_have_the_wanted_digits(self):
        write_rows(self.path, [{"name": "a, b", "count": 12345678, "share": 0.123456}], 3)
        self.assertEqual(read_rows(self.path), [{"name": "a, b", "count": "12345678", "share": "0.123"}])

    def test_a_table_of_cells_keeps_every_bit(self):
        write_table(self.path, ["name", "share"], [["a", 1 / 3]])
        self.assertEqual(columns_of(self.path), ["name", "share"])
        self.assertEqual(float(read_rows(self.path)[0]["share"]), 1 / 3)

    def test_a_packed_table_is_the_same(self):
        write_table(self.path, ["name", "share"], [["a", 0.5]])
        packed = self.path.with_suffix(".csv.gz")
        packed.write_bytes(gzip.compress(self.path.read_bytes()))
        self.assertEqual(read_rows(packed), read_rows(self.path))

    def test_a_growing_table_goes_on_below_its_rows(self):
        table = GrowingTable(self.path, 3, ["name", "share", "note"])
        self.assertEqual(table.rows, [])
        table.add([{"name": "a", "share": 0.12345}])
        again = GrowingTable(self.path, 3, ["name", "share", "note"])
        self.assertEqual(again.rows, [{"name": "a", "share": "0.123", "note": ""}])
        again.add([{"name": "b", "share": 2.0, "note": "c"}])
        self.assertEqual(self.path.read_text(), "name,share,note\na,0.123,\nb,2,c\n")

    def test_a_table_begun_anew_has_the_columns_of_its_first_row(self):
        self.path.write_text("of,an,earlier\n1,2,3\n")
        GrowingTable.anew(self.path, 3).add([{"name": "a"}])
        self.assertEqual(self.path.read_text(), "name\na\n")


if __name__ == "__main__":
    unittest.main()

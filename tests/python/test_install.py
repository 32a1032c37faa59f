# SPDX-License-Identifier: GPL-3.0-or-later
"""What CMake installs of the package, in a folder of its own: it is imported from there, and used."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

USE = """
import fretwork as fw
square = fw.make_outline([[0, 0], [0.2, 0], [0.2, 0.2], [0, 0.2]])
project, report = fw.make_project(square, patterns="0-1+1-6", edge_length=0.025)
print(fw.__file__)
print(len(fw.enumerate_patterns(fw.paper_layout())), report.tiles, fw.SurfaceFunction.__name__)
"""


class Install(unittest.TestCase):
    def test_is_imported_and_used(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run(["cmake", "--install", os.environ["FRETWORK_BINARY_DIR"], "--component", "python", "--prefix", folder],
                           check=True, capture_output=True)
            (package,) = pathlib.Path(folder).rglob("fretwork")
            self.assertEqual({"py.typed", "__init__.pyi", "__init__.py"} - {file.name for file in package.iterdir()}, set())
            done = subprocess.run([sys.executable, "-B", "-c", USE], check=True, capture_output=True, text=True, cwd=folder,
                                  env=os.environ | {"PYTHONPATH": str(package.parent)})
            place, numbers = done.stdout.splitlines()
            self.assertEqual(pathlib.Path(place).parent, package)
            self.assertEqual(numbers, "1824 33 SurfaceFunction")


if __name__ == "__main__":
    unittest.main()

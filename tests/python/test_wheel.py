# SPDX-License-Identifier: GPL-3.0-or-later
"""The wheel into an empty environment, by pip without the net, imported and used."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["FRETWORK_SOURCE_DIR"])
BUILD = os.environ["FRETWORK_BUILD_DIR"]  # where this test's module is built already
USE = "import fretwork as fw; print(fw.__file__, len(fw.enumerate_patterns(fw.paper_layout())), fw.paper_layout().places.shape)"


def run(*command):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    if done.returncode:
        raise AssertionError(f"{command}\n{done.stdout}{done.stderr}")
    return done.stdout


class Wheel(unittest.TestCase):
    def test_is_installed_and_used(self):
        with tempfile.TemporaryDirectory() as folder:
            run(sys.executable, "-m", "venv", "--system-site-packages", folder + "/own")  # numpy is Debian's
            python = folder + "/own/bin/python"
            run(python, "-m", "pip", "wheel", "--no-index", "--no-deps", "--wheel-dir", folder,
                "--config-settings", f"build-folder={BUILD}", SOURCE)
            wheel = next(pathlib.Path(folder).glob("fretwork-*.whl"))
            self.assertLessEqual(wheel.stat().st_size, 15e6)
            run(python, "-m", "pip", "install", "--no-index", wheel)
            told = run(python, "-I", "-c", USE).split()
            self.assertTrue(told[0].startswith(folder))
            self.assertEqual(told[1], "1824")


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""The stubs are complete, and examples pass mypy --strict."""

import ast
import importlib.util
import os
import pathlib
import subprocess
import sys
import unittest

import fretwork

import call_signatures
import support

PACKAGE = pathlib.Path(fretwork.__file__).parent


class Stubs(unittest.TestCase):
    def setUp(self):
        self.stub = {name for name, _ in call_signatures.declared(ast.parse((PACKAGE / "__init__.pyi").read_text()).body)}

    def test_declare_all_that_there_is(self):
        self.assertEqual([name for name, _ in support.public_parts() if name not in self.stub], [])

    def test_the_package_says_that_it_is_typed(self):
        self.assertTrue((PACKAGE / "py.typed").exists())

    def test_examples_pass_mypy_strict(self):
        if importlib.util.find_spec("mypy") is None:
            self.skipTest("mypy is not installed")
        examples = sorted((support.SOURCE / "apps/python/examples").glob("*.py"))
        self.assertGreater(len(examples), 0)
        if importlib.util.find_spec("torch") is None:
            examples = [example for example in examples if "torch" not in example.name]
        environment = {**os.environ, "MYPYPATH": str(PACKAGE.parent)}
        command = [sys.executable, "-m", "mypy", "--strict", "--cache-dir", os.devnull, *map(str, examples)]
        done = subprocess.run(command, env=environment, capture_output=True, text=True, cwd=support.SOURCE / "apps/python/examples")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_examples_run(self):
        for example in sorted((support.SOURCE / "apps/python/examples").glob("*.py")):
            if "torch" in example.name and importlib.util.find_spec("torch") is None:
                continue
            with self.subTest(example.name):
                done = subprocess.run([sys.executable, "-B", str(example)], capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    unittest.main()

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
import support

PACKAGE = pathlib.Path(fretwork.__file__).parent


def names_in(nodes, prefix=""):
    """The names that a stub declares, members with those of their classes in front."""
    for node in nodes:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            yield prefix + node.name
        if isinstance(node, ast.ClassDef):
            yield from names_in(node.body, prefix + node.name + ".")
        if isinstance(node, ast.AnnAssign):
            yield prefix + node.target.id
        if isinstance(node, ast.Assign):
            yield prefix + node.targets[0].id


class Stubs(unittest.TestCase):
    def setUp(self):
        self.stub = set(names_in(ast.parse((PACKAGE / "__init__.pyi").read_text()).body))

    def test_declare_all_that_there_is(self):
        missing = []
        for name, part in vars(fretwork).items():
            if name.startswith("_") or isinstance(part, type(ast)):
                continue
            if name not in self.stub:
                missing.append(name)
            if isinstance(part, type):
                missing += [f"{name}.{key}" for key in vars(part)
                            if not key.startswith("_") and f"{name}.{key}" not in self.stub]
        self.assertEqual(missing, [])

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

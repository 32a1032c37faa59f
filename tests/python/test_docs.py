# SPDX-License-Identifier: GPL-3.0-or-later
"""What the docstrings and the page show is what happens."""

import doctest
import inspect
import unittest

import fretwork
import support


def documented():
    """All docstrings with examples, under their names."""
    parts = {"fretwork": fretwork} | dict(support.public_parts(also=("__init__",)))
    return {name: inspect.getdoc(part) for name, part in parts.items() if ">>>" in (getattr(part, "__doc__", "") or "")}


class Docs(unittest.TestCase):
    def test_examples_in_docstrings_hold(self):
        parser = doctest.DocTestParser()
        found = documented()
        self.assertGreater(len(found), 20)
        for name, text in found.items():
            with self.subTest(name):
                runner = doctest.DocTestRunner(verbose=False)
                runner.run(parser.get_doctest(text, {}, name, name, 0))
                self.assertEqual(runner.summarize(verbose=False).failed, 0)

    def test_the_examples_of_the_page_run(self):
        page = (support.SOURCE / "apps/python/README.md").read_text()
        blocks = [block.partition("```")[0] for block in page.split("```python\n")[1:]]
        self.assertGreaterEqual(len(blocks), 1)
        for block in blocks:
            exec(compile(block, "README.md", "exec"), {})

    def test_every_public_function_says_something(self):
        silent = [name for name, part in support.public_parts()
                  if "." not in name and callable(part) and not (inspect.getdoc(part) or "").strip()]
        self.assertEqual(silent, [])


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the pages share: the repository, the program, and its pages."""

import os
import pathlib
import sys

sys.dont_write_bytecode = True
SOURCE = pathlib.Path(os.environ.get("FRETWORK_SOURCE_DIR", pathlib.Path(__file__).resolve().parents[2]))
PROGRAM = pathlib.Path(os.environ.get("FRETWORK_PROGRAM", SOURCE / "build/release/apps/fretwork/fretwork"))
IS_SLOW = bool(os.environ.get("FRETWORK_DOCS_SLOW"))
sys.path.insert(0, str(SOURCE / "scripts/site"))

import markdown_pages as markdown  # noqa: E402


# Pages whose blocks have no marks yet; tests/readmes compiles the first C++ example of the first, tests/python runs the Python of the third.
UNMARKED = {"framework/fretwork/simulation/README.md", "framework/fretwork/design/README.md", "apps/python/README.md", "experiments/inverse_design/README.md"}


def own_pages():
    """The site's own pages."""
    return sorted((SOURCE / "docs").rglob("*.md"))


def pages():
    """All pages of the repository whose blocks are marked."""
    return [page for page in markdown.pages(SOURCE) if page.relative_to(SOURCE).as_posix() not in UNMARKED]

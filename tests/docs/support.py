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


def pages():
    """The site's own pages."""
    return sorted((SOURCE / "docs").rglob("*.md"))

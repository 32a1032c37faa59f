#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Build the site from the repository's Markdown, the program's help, the Python module and the public headers. `build.py --help`."""

import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import time

import command_reference
import cpp_reference
import file_reference
import markdown_pages as markdown
import python_reference
import stage
import theme

HERE = pathlib.Path(__file__).resolve().parent
KATEX = pathlib.Path("/usr/share/javascript/katex")


def extend(page, written):
    """Put the table of a reference, and the tree of its pages, under the page that the repository has of it."""
    table, entries = written
    folder = page.stem
    text = page.read_text() + "\n" + table + stage.toctree([(title, f"{folder}/{name}") for title, name in entries], depth=1)
    page.write_text(text)


def write_references(source, program, package):
    reference = source / "docs/reference"
    extend(reference / "commands.md", command_reference.write(program, reference / "commands"))
    extend(reference / "cpp.md", cpp_reference.write(markdown.ROOT / "framework/fretwork", source.parent / "doxygen", reference / "cpp"))
    extend(reference / "files.md", file_reference.write(reference / "files"))
    if package:
        extend(reference / "python.md", python_reference.write(package, reference / "python"))
    else:
        extend(reference / "python.md", ("This site was built without the Python module: `make python docs` builds both.\n", []))


def copy_static(source):
    """Style, script, and KaTeX with its fonts: nothing is fetched when a page is read."""
    static = source / "_static"
    shutil.copytree(HERE / "static", static)
    (static / "katex").mkdir()
    for name in ("katex.min.js", "katex.min.css"):
        shutil.copy(KATEX / name, static / "katex")
    shutil.copytree(KATEX / "fonts", static / "katex/fonts")


def sort_search_index(out):
    """Sphinx reads pages side by side, and lists equal titles in the order in which their pages were ready: two builds would differ."""
    index = out / "searchindex.js"
    head, tail = "Search.setIndex(", ")"
    text = index.read_text()
    tables = json.loads(text[len(head):-len(tail)])
    for name in ("alltitles", "indexentries"):
        tables[name] = {title: sorted(places) for title, places in sorted(tables[name].items())}
    index.write_text(head + json.dumps(tables) + tail)


def build(out, program, package):
    """Build the site; gives 0, or what Sphinx gives where a page has a mistake."""
    source = out.parent / "site-source"
    shutil.rmtree(source, ignore_errors=True)
    shutil.rmtree(out, ignore_errors=True)
    source.mkdir(parents=True)
    rows = stage.contents((HERE / "contents.txt").read_text())
    stage.stage(source, rows)
    write_references(source, program, package)
    copy_static(source)
    shutil.copy(HERE / "conf.py", source)
    shutil.copy(HERE / "scorer.js", source)
    jobs = str(os.cpu_count() or 1)
    trees = source.parent / "site-doctrees"
    code = subprocess.run([sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-j", jobs, "-b", "html", "-d", trees, source, out]).returncode
    if code == 0:
        theme.mend(out)
        sort_search_index(out)
    return code


def main():
    parser = argparse.ArgumentParser(description=__doc__, epilog="Example: build.py --program build/release/apps/fretwork/fretwork --out build/site")
    parser.add_argument("--program", type=pathlib.Path, default=markdown.ROOT / "build/release/apps/fretwork/fretwork", help="the built program")
    parser.add_argument("--package", type=pathlib.Path, default=markdown.ROOT / "build/release/apps/python", help="the folder of the built Python package")
    parser.add_argument("--out", type=pathlib.Path, default=markdown.ROOT / "build/site", help="where the site goes")
    options = parser.parse_args()
    if not options.program.exists():
        parser.error(f"{options.program} is not there: build it by scripts/build.sh")
    started = time.monotonic()
    package = options.package if (options.package / "fretwork/__init__.py").exists() else None
    code = build(options.out.resolve(), options.program.resolve(), package)
    if code == 0:
        print(f"{options.out}/index.html: {len(list(options.out.glob('**/*.html')))} pages in {time.monotonic() - started:.0f} s")
        if not package:
            print("The reference of Python is left out: `make python docs` builds the module first.", file=sys.stderr)
    return code


if __name__ == "__main__":
    raise SystemExit(main())

# SPDX-License-Identifier: GPL-3.0-or-later
"""The site is built without a warning; no link in it is dead, nothing is fetched, every equation is set, and its search finds things from the disk."""

import html.parser
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import urllib.parse

import support

CHROMIUM = os.environ.get("CHROMIUM") or shutil.which("chromium")


class Page(html.parser.HTMLParser):
    """The links and the anchors of a built page, and what it loads."""

    def __init__(self, file):
        super().__init__()
        self.links, self.anchors, self.loaded = [], set(), []
        self.feed(file.read_text())

    def handle_starttag(self, tag, attributes):
        found = dict(attributes)
        self.anchors |= {found[name] for name in ("id", "name") if found.get(name)}
        if tag == "a" and found.get("href"):
            self.links.append(found["href"])
        for name in ("src", "href"):
            if tag in ("img", "script", "link") and found.get(name):
                self.loaded.append(found[name])


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.site = pathlib.Path(cls.folder.name) / "site"
        package = os.environ.get("FRETWORK_PACKAGE", "/nowhere")
        command = [sys.executable, "-B", support.SOURCE / "scripts/site/build.py", "--program", support.PROGRAM, "--package", package, "--out", cls.site]
        cls.built = subprocess.run(command, text=True, capture_output=True)
        cls.pages = {file: Page(file) for file in cls.site.rglob("*.html")}

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_is_built_without_a_warning(self):
        self.assertEqual(self.built.returncode, 0, self.built.stderr)
        self.assertGreater(len(self.pages), 100)

    def test_has_no_dead_link(self):
        for file, page in self.pages.items():
            for link in page.links + page.loaded:
                self.check(file, urllib.parse.urlparse(link))

    def check(self, file, link):
        if link.scheme in ("http", "https", "mailto", "data"):
            return
        target = (file.parent / urllib.parse.unquote(link.path)).resolve() if link.path else file
        place = f"{file.relative_to(self.site)}: {link.geturl()}"
        self.assertTrue(target.exists(), place)
        if link.fragment and target.suffix == ".html":
            self.assertIn(urllib.parse.unquote(link.fragment), self.pages[target].anchors, place)

    def test_fetches_nothing(self):
        for file, page in self.pages.items():
            for source in page.loaded:
                self.assertFalse(source.startswith(("http", "//", "/")), f"{file.relative_to(self.site)}: {source}")

    def test_pages_of_verbs_have_every_option_of_their_help(self):
        count = 0
        for page in sorted((self.site / "docs/reference/commands").glob("*.html")):
            text = page.read_text()
            help_text = subprocess.run([support.PROGRAM, page.stem, "--help"], text=True, capture_output=True, check=True).stdout
            for option in re.findall(r"^  (?:-\w,)?(--[\w-]+)", help_text, re.M):
                if option != "--help":
                    self.assertIn(f">{option}", text, page.name)
                    count += 1
        self.assertGreater(count, 100)

    def shown(self, page, *query):
        """A page as a browser has it once its scripts have run."""
        with tempfile.TemporaryDirectory() as profile:
            command = [CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={profile}", "--virtual-time-budget=10000", "--dump-dom",
                       page.as_uri() + "".join(query)]
            return subprocess.run(command, text=True, capture_output=True, timeout=120).stdout

    @unittest.skipUnless(CHROMIUM, "there is no Chromium")
    def test_sets_every_equation(self):
        count = 0
        for page in sorted((self.site / "docs/concepts").glob("*.html")):
            wanted = page.read_text().count('class="equation"')
            text = self.shown(page) if wanted else ""
            self.assertEqual(text.count('class="katex"'), wanted, page.name)
            self.assertNotIn("katex-error", text, page.name)
            count += wanted
        self.assertGreater(count, 60)

    @unittest.skipUnless(CHROMIUM, "there is no Chromium")
    def test_search_finds_pages_from_the_disk(self):
        text = self.shown(self.site / "search.html", "?q=corotational")
        self.assertIn("docs/concepts/corotational.html", text)
        self.assertIn("docs/reference/commands/simulate.html", text)


if __name__ == "__main__":
    unittest.main()

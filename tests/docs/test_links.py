# SPDX-License-Identifier: GPL-3.0-or-later
"""No link of a page is dead: each leads to a file, and to a heading where it names one; the table of contents has every page of the site."""

import unittest

import support
from support import markdown


class Links(unittest.TestCase):
    def test_lead_to_files_and_headings(self):
        count = 0
        for page in markdown.pages(support.SOURCE):
            for line, target in markdown.links(page.read_text()):
                if "://" in target or target.startswith("mailto:"):
                    continue
                count += 1
                self.check(page, line, target)
        self.assertGreater(count, 300)

    def check(self, page, line, target):
        path, _, anchor = target.partition("#")
        place = f"{page.relative_to(support.SOURCE)}:{line}: {target}"
        file = (page.parent / path).resolve() if path else page
        with self.subTest(place):
            self.assertTrue(file.exists(), f"{place}: no such file")
            if anchor:
                self.assertEqual(file.suffix, ".md", place)
                self.assertIn(anchor, markdown.anchors(file.read_text()), f"{place}: no such heading")

    def test_contents_have_every_page_once(self):
        import stage
        rows = stage.contents((support.SOURCE / "scripts/site/contents.txt").read_text())
        listed = [page for _, _, page in rows if page]
        self.assertEqual(len(listed), len(set(listed)))
        for page in listed:
            self.assertTrue((support.SOURCE / page).exists(), page)
        own = {page.relative_to(support.SOURCE).as_posix() for page in support.own_pages()} - {stage.HOME}
        self.assertEqual(own - set(listed), set())


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""What a release consists of agrees: versions wherever they are written, the citation, and the paper."""

import re
import unittest

import jsonschema
import yaml

import support

PROJECT = re.search(r"project\(fretwork VERSION (\d+)\.(\d+)\.(\d+) ", (support.SOURCE / "CMakeLists.txt").read_text())
VERSION = ".".join(PROJECT.groups())
DEBIAN = support.SOURCE / "debian"

# The part of the Citation File Format 1.2.0 that CITATION.cff uses: its required keys, and no others than it knows.
PEOPLE = {"type": "array", "minItems": 1, "items": {"oneOf": [
    {"type": "object", "required": ["name"], "properties": {"name": {"type": "string"}, "email": {"type": "string"}, "website": {"type": "string"}},
     "additionalProperties": False},
    {"type": "object", "required": ["family-names", "given-names"],
     "properties": {"family-names": {"type": "string"}, "given-names": {"type": "string"}, "orcid": {"type": "string"}}, "additionalProperties": False}]}}
TEXT = {"type": "string", "minLength": 1}
REFERENCE = {"type": "object", "required": ["authors", "title", "type"], "additionalProperties": False,
             "properties": {"type": {"enum": ["article", "software", "book", "conference-paper"]}, "title": TEXT, "authors": PEOPLE, "journal": TEXT,
                            "year": {"type": "integer"}, "volume": {"type": ["integer", "string"]}, "start": {"type": ["integer", "string"]},
                            "end": {"type": ["integer", "string"]}, "doi": {"type": "string", "pattern": r"^10\.\d{4,}/"}}}
CITATION = {"type": "object", "required": ["cff-version", "message", "title", "authors"], "additionalProperties": False,
            "properties": {"cff-version": {"const": "1.2.0"}, "message": TEXT, "title": TEXT, "type": {"enum": ["software", "dataset"]},
                           "license": {"const": "GPL-3.0-or-later"}, "version": TEXT, "date-released": {}, "authors": PEOPLE,
                           "references": {"type": "array", "minItems": 1, "items": REFERENCE}}}


def citation():
    return yaml.safe_load((support.SOURCE / "CITATION.cff").read_text())


def paper():
    """The front matter of the paper, and its text."""
    _, head, text = (support.SOURCE / "docs/paper/paper.md").read_text().split("---\n", 2)
    return yaml.safe_load(head), text


class Release(unittest.TestCase):
    def test_the_citation_is_valid(self):
        jsonschema.Draft202012Validator(CITATION).validate(citation())

    def test_the_citation_names_the_version(self):
        self.assertEqual(citation()["version"], VERSION)

    @unittest.skipUnless(DEBIAN.is_dir(), "the packages' files are not in this tree")
    def test_the_packages_name_the_version(self):
        self.assertTrue((DEBIAN / "changelog").read_text().startswith(f"fretwork ({VERSION}) "))

    @unittest.skipUnless(DEBIAN.is_dir(), "the packages' files are not in this tree")
    def test_the_package_of_the_library_is_named_by_its_soname(self):
        major, minor, _ = PROJECT.groups()
        package = "libfretwork" + (f"0.{minor}" if major == "0" else major)
        control = (DEBIAN / "control").read_text()
        self.assertEqual(re.findall(r"^Package: (libfretwork[\d.]+)$", control, re.M), [package])
        self.assertIn(f"{package} (= ${{binary:Version}})", control)
        self.assertTrue((DEBIAN / f"{package}.install").is_file())

    def test_the_paper_has_the_form_that_its_journal_asks_for(self):
        head, text = paper()
        self.assertLessEqual({"title", "tags", "authors", "affiliations", "date", "bibliography"}, set(head))
        known = {affiliation["index"] for affiliation in head["affiliations"]}
        self.assertTrue(all(author["affiliation"] in known for author in head["authors"]))
        headings = re.findall(r"^# (.+)$", text, re.M)
        self.assertEqual([headings[0], headings[1], headings[-1]], ["Summary", "Statement of need", "References"])
        words = len(text.split())
        self.assertTrue(250 <= words <= 1000, f"{words} words, where the journal asks for 250 to 1000")

    def test_the_paper_cites_what_its_bibliography_has_and_nothing_else(self):
        _, text = paper()
        cited = set(re.findall(r"@([A-Za-z]+\d*\w*)", text))
        entries = set(re.findall(r"^@\w+\{(\w+),", (support.SOURCE / "docs/paper/paper.bib").read_text(), re.M))
        self.assertEqual(cited, entries)


if __name__ == "__main__":
    unittest.main()

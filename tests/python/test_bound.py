# SPDX-License-Identifier: GPL-3.0-or-later
"""Every public function and type of the framework is in the module, or not_bound.txt says why not."""

import re
import unittest

import fretwork as fw
import support

FRAMEWORK = support.SOURCE / "framework" / "fretwork"
TYPE = re.compile(r"^(?:struct|class|enum class) (\w+)(?= (?:final )?[:{])", re.M)
FUNCTION = re.compile(r"^(?!using|template|namespace|class|struct|enum|extern|typedef|return|#|//)"
                      r"(?:\[\[nodiscard\]\] |inline |constexpr )*[A-Za-z_][\w:<>,&* ]*?[ &*](\w+)\(", re.M)


def public_headers():
    """The headers that are installed: those in the lists HEADERS of the stages."""
    for stage in sorted(FRAMEWORK.iterdir()):
        if (stage / "CMakeLists.txt").exists():
            listed = (stage / "CMakeLists.txt").read_text().partition("HEADERS")[2]
            for name in re.findall(r"[\w/]+\.hpp", listed):
                yield f"{stage.name}/{name}", (stage / name).read_text()


def enums():
    """Name of each enum in the headers, and the lists of members of all enums with that name, as words."""
    found = {}
    for header in FRAMEWORK.rglob("*.hpp"):
        for name, body in re.findall(r"enum class (\w+)[^{;]*\{(.*?)\}", header.read_text(), re.S):
            members = re.findall(r"(\w+)\s*(?:=[^,]*)?(?:,|$)", re.sub(r"//.*", "", body).strip())
            words = [re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "-", member).lower() for member in members]
            found.setdefault(name, []).append(words)
    return found


def bound_enums():
    """Name in C++ and class in Python of each enum of the module. Others are words without a class."""
    text = (support.SOURCE / "apps/python/bind/core/enums.hpp").read_text()
    rows = re.findall(r"^FRETWORK_ENUM\((?:\w+::)*(\w+),\s*\"(\w+)\"", text, re.M)
    return [(name, getattr(fw, python_name)) for name, python_name in rows if hasattr(fw, python_name)]


def bound_names():
    """Names of the module, and of its classes' members."""
    names = set()

    def add(owner):
        for name, part in vars(owner).items():
            names.add(name)
            if isinstance(part, type) and part.__module__.startswith("fretwork"):
                add_members(part)

    def add_members(kind):
        for name, part in vars(kind).items():
            names.add(name)
            if isinstance(part, type) and part is not kind and part.__module__.startswith("fretwork"):
                add_members(part)

    add(fw)
    return names


def reasons():
    """Rows of not_bound.txt: a name, or a header or a folder with a slash, and why."""
    rows = {}
    for line in (support.SOURCE / "tests/python/not_bound.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            key, _, reason = line.partition(": ")
            rows[key] = reason
    return rows


def unbound():
    known = bound_names()
    for header, text in public_headers():
        for name in dict.fromkeys(TYPE.findall(text) + FUNCTION.findall(text)):
            if name not in known and name != "operator":
                yield header, name


class Bound(unittest.TestCase):
    def test_what_is_missing_has_its_reason(self):
        rows, used, silent = reasons(), set(), []
        for header, name in unbound():
            keys = [key for key in rows if key in (name, header) or (key.endswith("/") and header.startswith(key))]
            used.update(keys)
            if not keys:
                silent.append(f"{header}: {name}")
        self.assertEqual(silent, [])
        self.assertEqual(sorted(set(rows) - used), [], "these are bound, or no longer there")

    def test_enums_have_a_word_for_each_member(self):
        members = enums()
        self.assertGreater(len(bound_enums()), 20)
        for name, kind in bound_enums():
            self.assertIn([member.value for member in kind], members[name], kind)

    def test_reasons_say_something(self):
        for key, reason in reasons().items():
            self.assertTrue(reason.strip(), key)


if __name__ == "__main__":
    unittest.main()

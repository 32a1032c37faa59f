# SPDX-License-Identifier: GPL-3.0-or-later
"""The repository's Markdown: its pages, their code blocks with marks, their links and anchors. Used by the site and by its tests."""

import dataclasses
import os
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
NO_PAGES = {"build", "out", "node_modules", "dist", ".git", ".cache"}
LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)\s]+)((?:\s+\"[^\"]*\")?)\)")
MARK = re.compile(r"<!--\s*(run slow|run|prints|program|compiled|tour|no run:[^>]*?|query)\s*-->")
SETUP = re.compile(r"<!-- setup\n(.*?)-->", re.S)


def pages(root=ROOT):
    """All Markdown files below a folder, those that are built left out, in order."""
    found = []
    for folder, folders, files in os.walk(root):
        folders[:] = sorted(name for name in folders if name not in NO_PAGES)
        found += [pathlib.Path(folder) / name for name in files if name.endswith(".md")]
    return sorted(found)


@dataclasses.dataclass
class Block:
    """A fenced block of a page: its language, its text, the mark above it, the number of its first line; a setup is a block, too."""

    language: str
    text: str
    mark: str
    line: int


def blocks(text):
    """The fenced blocks and setups of a page, in order."""
    found = []
    mark = ""
    lines = text.split("\n")
    i = 0
    while i < len(lines):
        line = lines[i]
        if line == "<!-- setup":
            end = lines.index("-->", i)
            found.append(Block("sh", "\n".join(lines[i + 1:end]), "setup", i + 2))
            i = end
        elif line.startswith("```"):
            end = next(j for j in range(i + 1, len(lines)) if lines[j].startswith("```"))
            found.append(Block(line[3:].strip(), "\n".join(lines[i + 1:end]), mark, i + 2))
            mark = ""
            i = end
        elif match := MARK.fullmatch(line.strip()):
            mark = match[1]
        elif line.strip():
            mark = ""
        i += 1
    return found


def without_code(text):
    """The page with code blocks, code spans and comments blanked, line by line."""
    text = re.sub(r"<!--.*?-->", lambda found: "\n" * found[0].count("\n"), text, flags=re.S)
    lines = []
    is_code = False
    for line in text.split("\n"):
        is_fence = line.lstrip().startswith("```")
        lines.append("" if is_code or is_fence else re.sub(r"`[^`]*`", "", line))
        is_code ^= is_fence
    return "\n".join(lines)


def escaped(text):
    """Words of a comment as Markdown that shows them as they are; code spans stay."""
    parts = re.split(r"(`[^`]*`)", text)
    return "".join(part if part.startswith("`") else re.sub(r"([<>*_$\[\]|])", r"\\\1", part) for part in parts)


def slug(heading):
    """The anchor of a heading, as GitHub and MyST make it."""
    plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading.strip())
    return re.sub(r"[^\w\- ]", "", plain.lower()).replace(" ", "-")


def anchors(text):
    """The anchors of a page's headings, and those that it names itself."""
    text = re.sub(r"<!--.*?-->", "", text, flags=re.S)
    found = set(re.findall(r"^\(([\w-]+)\)=$", text, re.M))
    is_code = False
    for line in text.split("\n"):
        if line.startswith("```"):
            is_code = not is_code
        elif not is_code and (match := re.match(r"#{1,6} (.*)", line)):
            found.add(slug(match[1]))
    return found


def links(text):
    """Line number and target of each link of a page."""
    return [(number, match[3]) for number, line in enumerate(without_code(text).split("\n"), 1) for match in LINK.finditer(line)]

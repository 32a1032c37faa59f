# SPDX-License-Identifier: GPL-3.0-or-later
"""The reference of C++, from the comments of the public headers: a page for each stage."""

import pathlib
import re

import cpp_headers
from markdown_pages import escaped


def comment(symbol):
    return "\n\n".join(filter(None, (escaped(symbol.brief), escaped(symbol.detail))))


def short(name):
    return name.rpartition("::")[2]


def label(name):
    """A name within the namespace of its stage."""
    return re.sub(r"^fretwork::\w+::", "", name)


def member_text(member):
    words = " ".join(comment(member).split("\n\n")).replace("\n", " ")
    return f"- `{member.text}`" + (f"<br>{words}" if words else "")


def symbol_text(symbol):
    text = [f"### {escaped(label(symbol.name))}", "", "```cpp", symbol.text, "```", "", comment(symbol), ""]
    if symbol.kind == "enum":
        text += [f"- `{value.name}`" + (f": {' '.join(comment(value).split())}" if comment(value) else "") for value in symbol.members]
    else:
        shown = [member for member in symbol.members if not (member.is_exempt and not member.says_something)]
        text += [member_text(member) for member in shown]
    return "\n".join(text) + "\n"


def overloads(symbols):
    """Functions of one name follow each other under one heading."""
    grouped = {}
    for symbol in symbols:
        grouped.setdefault((symbol.kind, symbol.name), []).append(symbol)
    return grouped.values()


def header_text(header, symbols):
    text = [f"## {header}", "", "```cpp", f"#include <fretwork/{header}>", "```", ""]
    for same in overloads(symbols):
        first = symbol_text(same[0])
        text.append(first)
        for other in same[1:]:
            text += ["```cpp", other.text, "```", "", comment(other), ""]
    return "\n".join(text)


def write(framework, out, folder):
    """Write a page for each stage; gives a table of them, and the pages as (title, file name)."""
    folder.mkdir(parents=True, exist_ok=True)
    symbols = cpp_headers.read_headers(framework, out)
    index = ["| stage | headers | types and functions |", "|---|--:|--:|"]
    entries = []
    for stage, headers in cpp_headers.public_headers(framework).items():
        names = [str(header.relative_to(framework)) for header in headers]
        texts = [header_text(name, symbols[name]) for name in names if symbols[name]]
        (folder / f"{stage}.md").write_text(f"# {stage}\n\nNamespace `fretwork::{stage}`. Link `fretwork::{stage}`.\n\n" + "\n".join(texts))
        index.append(f"| [`{stage}`](cpp/{stage}.md) | {len(names)} | {sum(len(symbols[name]) for name in names)} |")
        entries.append((stage, stage))
    return "\n".join(index) + "\n", entries

# SPDX-License-Identifier: GPL-3.0-or-later
"""The reference of the Python module, from its docstrings: functions, values, words, errors."""

import enum
import importlib
import inspect
import re
import sys

from markdown_pages import escaped


def split_doc(part):
    """The signatures that a binding writes first, and the words."""
    lines = (inspect.getdoc(part) or "").split("\n")
    signatures = []
    while lines and re.match(r"(\d+\. )?[\w.]+\(.*\)( -> .*)?$", lines[0]):
        signatures.append(re.sub(r"\bfretwork\._core\.|_core\.", "", lines.pop(0)))
    return signatures, "\n".join(lines).strip()


def words_text(words):
    """Words of a docstring as Markdown; examples as Python."""
    text, code = [], []
    for line in words.split("\n") + [""]:
        is_example = line.startswith((">>>", "...")) or (code and line.strip())
        if is_example:
            code.append(line)
            continue
        if code:
            text += ["", "```pycon", *code, "```", ""]
            code = []
        text.append(escaped(line))
    return "\n".join(text)


def function_text(name, part, level=2):
    signatures, words = split_doc(part)
    return "\n".join([f"{'#' * level} {escaped(name)}", "", *(["```python", *signatures, "```", ""] if signatures else []), words_text(words), ""])


def class_text(name, kind):
    text = [f"## {escaped(name)}", "", words_text(split_doc(kind)[1] or (kind.__doc__ or "")), ""]
    for key, part in sorted(vars(kind).items()):
        if key.startswith("_"):
            continue
        if inspect.isclass(part):
            text.append(f"- `{name}.{key}`: {escaped(' '.join((part.__doc__ or '').split()))}")
        else:
            signatures, words = split_doc(part)
            shown = signatures[0] if signatures else key
            text.append(f"- `{shown}`: {escaped(' '.join(words.split('>>>')[0].split()))}".rstrip(": "))
    return "\n".join(text) + "\n"


def enum_text(name, kind):
    return "\n".join([f"## {escaped(name)}", "", escaped(inspect.getdoc(kind) or ""), "", *(f"- `{value.name}`" for value in kind)]) + "\n"


def parts_of(module):
    """Functions, classes, enums and errors of the module, by name."""
    found = {"functions": {}, "classes": {}, "enums": {}, "errors": {}}
    for name, part in sorted(vars(module).items()):
        if name.startswith("_") or inspect.ismodule(part):
            continue
        if inspect.isclass(part):
            kind = "errors" if issubclass(part, BaseException) else "enums" if issubclass(part, enum.Enum) else "classes"
        else:
            kind = "functions" if callable(part) else None
        if kind:
            found[kind][name] = part
    return found


def write(package, folder):
    """Write the pages from the module in a folder; gives a table of them, and the pages as (title, file name)."""
    folder.mkdir(parents=True, exist_ok=True)
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(package))
    parts = parts_of(importlib.import_module("fretwork"))
    pages = {
        "functions": ("Functions", [function_text(name, part) for name, part in parts["functions"].items()]),
        "values": ("Values", [class_text(name, part) for name, part in parts["classes"].items()]),
        "words": ("Enumerations", [enum_text(name, part) for name, part in parts["enums"].items()]),
        "errors": ("Errors", [function_text(name, part) for name, part in parts["errors"].items()]),
    }
    index = ["| page | names |", "|---|--:|"]
    for file, (title, texts) in pages.items():
        (folder / f"{file}.md").write_text(f"# {title} of the Python module\n\n" + "\n".join(texts))
        index.append(f"| [{title}](python/{file}.md) | {len(texts)} |")
    return "\n".join(index) + "\n", [(title, file) for file, (title, _) in pages.items()]

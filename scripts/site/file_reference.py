# SPDX-License-Identifier: GPL-3.0-or-later
"""The reference of file formats, from their JSON schemas: a page for each kind, with its keys and an example of the repository."""

import json
import shutil

import markdown_pages as markdown

SCHEMAS = markdown.ROOT / "docs/schemas"
NAMES = {"minimum": ">=", "exclusiveMinimum": ">", "maximum": "<=", "exclusiveMaximum": "<"}
PLURALS = {"number": "numbers", "integer": "integers", "string": "strings", "object": "objects"}
DEPTH = 5


def resolve(node, file):
    """The schema that a reference names, and its file."""
    while "$ref" in node:
        path, _, place = node["$ref"].partition("#")
        file = path or file
        node = json.loads((SCHEMAS / file).read_text())
        for step in filter(None, place.split("/")):
            node = node[step]
    return node, file


def number_text(number):
    """A limit as a person writes it: 1e12."""
    digits, _, power = f"{number:g}".partition("e")
    short = f"{digits}e{int(power)}" if power else digits
    return short if isinstance(number, float) and float(short) == number else str(number)


def kind_of(node, file):
    """A value's kind in words."""
    node, file = resolve(node, file)
    for choice in ("oneOf", "anyOf"):
        if choice in node:
            return " or ".join(dict.fromkeys(kind_of(option, file) for option in node[choice]))
    if "const" in node:
        return f"`{json.dumps(node['const'])}`"
    if "enum" in node:
        return ", ".join(f"`{json.dumps(value)}`" for value in node["enum"])
    kind = node.get("type", "object" if rows(node, file) else "any value")
    kind = " or ".join(kind) if isinstance(kind, list) else kind
    if kind == "array":
        count = "" if "minItems" not in node else f"at least {node['minItems']} " if node["minItems"] != node.get("maxItems") else f"{node['minItems']} "
        elements = node.get("prefixItems", [node["items"]] if isinstance(node.get("items"), dict) else [])
        inner = ", then ".join(dict.fromkeys(kind_of(element, file) for element in elements)) or "values"
        return f"list of {count}{PLURALS.get(inner, f'({inner})')}"
    limits = " and ".join(f"{sign} {number_text(node[name])}" for name, sign in NAMES.items() if name in node)
    return f"{kind} {limits}".strip()


def rows(node, file, path="", depth=0):
    """A row for each key below a schema."""
    node, file = resolve(node, file)
    if depth > DEPTH:
        return []
    found = []
    if isinstance(node.get("items"), dict):
        found += rows(node["items"], file, path + "[]", depth + 1)
    for choice in ("oneOf", "anyOf", "allOf"):
        for option in node.get(choice, []):
            found += rows(option, file, path, depth + 1)
    for key, value in node.get("properties", {}).items():
        name = f"{path}.{key}" if path else key
        words = value.get("description", "") if isinstance(value, dict) else ""
        if value is False or value is True:
            continue
        found.append((name, kind_of(value, file), "yes" if key in node.get("required", []) else "", words))
        found += rows(value, file, name, depth + 1)
    return list(dict.fromkeys(found))


def example(formats):
    """The smallest data file of the repository that has one of these formats."""
    found = []
    for file in markdown.ROOT.glob("experiments/**/*.json"):
        text = file.read_text(errors="replace")
        if any(f'"{name}"' in text[:200] for name in formats):
            found.append((len(text), file, text))
    return min(found)[1:] if found else (None, "")


def page(schema_file):
    schema = json.loads(schema_file.read_text())
    kind = schema_file.name.removesuffix(".schema.json")
    format_node = schema.get("properties", {}).get("format", {})
    formats = format_node.get("enum", [format_node["const"]] if "const" in format_node else [])
    text = [f"# {kind}", "", f"{schema.get('title', '')}.", ""]
    if formats:
        text += ["The key `format` is " + ", ".join(f"`{name}`" for name in formats) + ".", ""]
    text += [f"Schema: [`{schema_file.name}`](../../schemas/{schema_file.name}). `fretwork check FILE` says whether a file is valid.", ""]
    file, content = example(formats)
    if file and len(content) < 4000:
        text += [f"An example, `{file.relative_to(markdown.ROOT)}`:", "", "```json", content.strip(), "```", ""]
    text += ["## Keys", "", "`[]` stands for each element of a list.", "", "| key | value | required |", "|---|---|---|"]
    text += [f"| `{name}` | {kind.replace('|', chr(92) + '|')} | {needed} |" for name, kind, needed, _ in rows(schema, schema_file.name)]
    return "\n".join(text) + "\n", schema.get("title", "")


def write(folder):
    """Write a page for each kind; gives a table of them, and the pages as (title, file name)."""
    folder.mkdir(parents=True, exist_ok=True)
    schemas = folder.parents[1] / "schemas"
    schemas.mkdir(parents=True, exist_ok=True)
    index = ["| kind | content |", "|---|---|"]
    entries = []
    for schema_file in sorted(SCHEMAS.glob("*.schema.json")):
        kind = schema_file.name.removesuffix(".schema.json")
        text, title = page(schema_file)
        shutil.copy(schema_file, schemas)
        (folder / f"{kind}.md").write_text(text)
        index.append(f"| [{kind}](files/{kind}.md) | {title} |")
        entries.append((kind, kind))
    return "\n".join(index) + "\n", entries

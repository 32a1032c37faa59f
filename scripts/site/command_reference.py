# SPDX-License-Identifier: GPL-3.0-or-later
"""The reference of the command line, from the program's own manual: a page for each verb."""

import re
import subprocess


def plain(roff):
    """A line of the manual without its marks."""
    text = re.sub(r"\\f[BIRP]", "", roff)
    return re.sub(r"^\.B ", "", text).replace("\\-", "-").replace("\\&", "").replace("\\(aq", "'").replace('\\(dq', '"').replace("\\e", "\\")


def sections(manual):
    """Title and lines of each section of the manual page that is one of a verb."""
    parts = re.split(r"^\.SH ", manual, flags=re.M)[1:]
    for part in parts:
        title, _, body = part.partition("\n")
        title = title.strip().strip('"')
        if title.startswith("fretwork"):
            yield plain(title), body.split("\n")


def read_section(lines):
    """Summary, options as (name, words), and the lines of its examples."""
    summary, options, examples = [], [], []
    place = "summary"
    for line in lines:
        if line == ".TP":
            place = "name"
        elif line == ".nf":
            place = "examples"
        elif line in (".PP", ".fi"):
            place = "summary" if not options and line == ".PP" else "rest"
        elif line.startswith(".SS"):
            place = "rest"
        elif place == "name":
            options.append((plain(line), []))
            place = "words"
        elif place == "words":
            options[-1][1].append(plain(line))
        elif place == "examples":
            examples.append(plain(line))
        elif place == "summary":
            summary.append(plain(line))
    return " ".join(summary).strip(), options, examples


def escape(text):
    """Plain words as Markdown: other than in comments, a backslash is meant as one."""
    return re.sub(r"([*_<>\[\]|$\\])", r"\\\1", text)


def option_text(name, lines):
    """An option as an entry of a definition list; choices, which are `name: words` lines, as a list."""
    body = [escape(lines[0].strip())] if lines else [""]
    for line in lines[1:]:
        choice = re.fullmatch(r"(\S+(?: --content \w+)?): (.*)", line.strip())
        body.append(f"- `{choice[1]}`: {escape(choice[2])}" if choice else f"- {escape(line.strip())}")
    listing = "\n".join([body[0]] + ([""] + body[1:] if body[1:] else []))
    return f"`{name}`\n: " + listing.replace("\n", "\n  ")


def verb_text(title, lines, level):
    summary, options, examples = read_section(lines)
    text = [f"{'#' * level} {title}", "", escape(summary), ""]
    text += [entry + "\n" for entry in (option_text(name, words) for name, words in options if not name.startswith("-h"))]
    while examples and not examples[0].strip():
        examples.pop(0)
    if examples:
        text += ["```text", *examples, "```", ""]
    return "\n".join(text)


def groups(help_text):
    """The verbs of each group, as `fretwork --help` lists them, with their words."""
    found = {}
    group = None
    for line in help_text.split("\n"):
        if line.endswith(":") and not line.startswith(" "):
            group = line[:-1]
        elif group and group != "Options" and (match := re.match(r"  (\S+)\s{2,}(.*)", line)):
            found.setdefault(group, []).append(match.groups())
    return found


def write(program, folder):
    """Write the verbs' pages; gives a table of them, and the pages as (title, file name)."""
    def printed(*arguments):
        return subprocess.run([program, *arguments], text=True, check=True, capture_output=True).stdout

    folder.mkdir(parents=True, exist_ok=True)
    verbs = {}
    for title, lines in sections(printed("manual", "--man")):
        words = title.split()
        if len(words) > 1:
            verbs.setdefault(words[1], []).append(verb_text(title, lines, 1 if len(words) == 2 else 2))
    index = []
    entries = []
    for group, members in groups(printed("--help")).items():
        index += [f"## {group}", "", "| verb | what it does |", "|---|---|"]
        for verb, words in members:
            index.append(f"| [`{verb}`](commands/{verb}.md) | {escape(words)} |")
            entries.append((verb, verb))
            (folder / f"{verb}.md").write_text("\n".join(verbs[verb]))
        index.append("")
    return "\n".join(index), entries

# SPDX-License-Identifier: GPL-3.0-or-later
"""The source of the site: the repository's Markdown with its pictures, laid out for Sphinx, and the table of contents.

Nothing of a page is changed but what only a repository can show: a link to a folder goes to its page, or becomes plain text.
"""

import os
import re
import shutil

import markdown_pages as markdown

HOME = "docs/index.md"


def contents(text):
    """The table of contents: (depth, title, page) of each line; a caption has no page."""
    rows = []
    for line in text.split("\n"):
        if not line.strip() or line.startswith("# SPDX"):
            continue
        if line.startswith("# "):
            rows.append((0, line[2:].strip(), None))
        else:
            title, _, page = line.strip().partition(" | ")
            rows.append(((len(line) - len(line.lstrip())) // 2, title, page.strip()))
    return rows


def toctree(entries, caption=None, depth=2):
    lines = ["", "```{toctree}", ":hidden:", f":maxdepth: {depth}"]
    lines += [f":caption: {caption}"] if caption else []
    return "\n".join(lines + [""] + [f"{title} <{page}>" for title, page in entries] + ["```", ""])


def trees(rows):
    """The text to put under each page: the home page gets a tree for each caption, a parent one of its children."""
    captions, children, parents = {}, {}, {}
    caption = ""
    for depth, title, page in rows:
        if page is None:
            caption = title
            continue
        parents[depth] = page
        entry = (title, "/" + page.removesuffix(".md"))
        if depth == 0:
            captions.setdefault(caption, []).append(entry)
        else:
            children.setdefault(parents[depth - 1], []).append(entry)
    text = {page: toctree(entries) for page, entries in children.items()}
    text[HOME] = "".join(toctree(entries, caption) for caption, entries in captions.items())
    return text


def shown(page, text, move=""):
    """A page's text for the site. `move`: what to put before relative links, where the page lies elsewhere there."""
    def mend(found):
        mark, words, target, title = found.groups()
        path, _, anchor = target.partition("#")
        if not path or "://" in path or path.startswith("mailto:"):
            return found[0]
        real = (page.parent / path).resolve()
        if real.is_dir():
            if not (real / "README.md").exists():
                return words
            path = path.rstrip("/") + "/README.md"
        if real == (markdown.ROOT / HOME).resolve():
            path = os.path.relpath(markdown.ROOT / "index.md", page.parent)
        return f"{mark}[{words}]({move}{path}{'#' + anchor if anchor else ''}{title})"

    text = re.sub(r"<!--.*?-->\n?", "", text, flags=re.S)
    parts = re.split(r"(^```.*?^```$)", text, flags=re.S | re.M)
    return "".join(part if part.startswith("```") else markdown.LINK.sub(mend, part) for part in parts)


def copy_targets(page, text, source):
    """Files that a page links to or shows."""
    for _, target in markdown.links(text):
        path = target.partition("#")[0]
        real = (page.parent / path).resolve()
        if path and "://" not in target and real.is_file() and real.suffix != ".md":
            copy = source / real.relative_to(markdown.ROOT)
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(real, copy)


def stage(source, rows):
    """Write the site's source into a folder."""
    below = trees(rows)
    listed = {page for _, _, page in rows}
    for page in markdown.pages():
        name = page.relative_to(markdown.ROOT).as_posix()
        text = page.read_text()
        copy_targets(page, text, source)
        is_home = name == HOME
        body = shown(page, text, "docs/" if is_home else "") + below.get(name, "")
        if name not in listed and not is_home:
            body = "---\norphan: true\n---\n\n" + body
        copy = source / ("index.md" if is_home else name)
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(body)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Sphinx' settings for the site: Markdown by MyST, the theme furo, equations by KaTeX; no file comes from a network."""

import html
import pathlib

from docutils import nodes

project = "Fretwork"
author = "The Fretwork authors"
extensions = ["myst_parser", "sphinx_copybutton"]
myst_enable_extensions = ["dollarmath", "deflist"]
myst_heading_anchors = 4
myst_dmath_allow_labels = False
source_suffix = {".md": "markdown"}
exclude_patterns = ["_static"]
smartquotes = False  # they would make a dash of the two hyphens of an option
html_theme = "furo"
html_title = "Fretwork"
html_static_path = ["_static"]
html_search_scorer = str(pathlib.Path(__file__).with_name("scorer.js"))
html_css_files = ["site.css", "katex/katex.min.css"]
html_js_files = ["katex/katex.min.js", "equations.js"]
html_math_renderer = "katex"
html_copy_source = False
html_show_sphinx = False
html_show_copyright = False
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#1f5fae", "color-brand-content": "#1f5fae",
                            "font-stack": "'DejaVu Sans', system-ui, sans-serif"},
    "dark_css_variables": {"color-brand-primary": "#8ab8ee", "color-brand-content": "#8ab8ee"},
}
copybutton_exclude = ".linenos, .gp, .go"
copybutton_selector = "div:not(.highlight-text) > div.highlight > pre"
pygments_style = "tango"
pygments_dark_style = "monokai"
suppress_warnings = ["misc.highlighting_failure"]


def inline_equation(self, node):
    self.body.append(f'<span class="equation">{html.escape(node.astext())}</span>')
    raise nodes.SkipNode


def displayed_equation(self, node):
    self.body.append(f'<div class="equation">{html.escape(node.astext())}</div>')
    raise nodes.SkipNode


def shorten_contents(_app, env):
    """Keep two levels of headings in the contents of reference pages: Sphinx copies all contents for the sidebar of each page, and they have a thousand."""
    for name, contents in env.tocs.items():
        if name.startswith("docs/reference/") and name.count("/") == 3:
            for item in list(contents.findall(nodes.list_item)):
                depth = sum(isinstance(parent, nodes.list_item) for parent in parents_of(item))
                if depth == 1:
                    item.children[1:] = []
    return []


def parents_of(node):
    """The nodes above a node."""
    while node.parent is not None:
        node = node.parent
        yield node


def setup(app):
    app.connect("env-updated", shorten_contents)
    app.add_html_math_renderer("katex", inline_renderers=(inline_equation, None), block_renderers=(displayed_equation, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}

# SPDX-License-Identifier: GPL-3.0-or-later
"""What Debian's build of the theme furo leaves open, mended in the built site: its parts lie in files that a page from the disk cannot load.

- its script imports another one, which a browser refuses for a plain script: both become one file;
- its style imports normalize.css from the root of a web server: its text takes the place of the import;
- its dark colours follow the button, but not the reader's system: the block of colours is repeated for that.
"""

import pathlib
import re

NORMALIZE = pathlib.Path("/usr/share/javascript/normalize.css/normalize.css")


def replaced(text, old, new, file):
    """Replace what has to be there: another version of the theme shall not pass unseen."""
    if old not in text:
        raise SystemExit(f"{file}: `{old[:60]}` is not there; scripts/site/theme.py knows furo 2022.12 of Debian 12")
    return text.replace(old, new)


def mend_script(static):
    script = static / "scripts/furo.js"
    line = 'import Gumshoe from "./gumshoe-patched.js";\n'
    script.write_text(replaced(script.read_text(), line, (static / "scripts/gumshoe-patched.js").read_text(), script))


def mend_style(static):
    style = static / "styles/furo.css"
    text = replaced(style.read_text(), "@import url(/javascript/normalize.css/normalize.css);", NORMALIZE.read_text(), style)
    colours = re.search(r'body\[data-theme="dark"\] \{(.*?)\}', text, re.S)[1]
    text += f'\n@media screen and (prefers-color-scheme: dark) {{\n  body:not([data-theme="light"]) {{{colours}}}\n}}\n'
    style.write_text(text)


def mend(out):
    mend_script(out / "_static")
    mend_style(out / "_static")

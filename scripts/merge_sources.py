#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Write the sources that a build compiles as one into one file each, for clang-tidy.

Its analyzer looks only at the functions of the main file, and so not at sources that are included.
Usage: scripts/merge_sources.py BUILD   reads BUILD/compile_commands.json of a quick build without precompiled headers;
writes BUILD/merged/*.cpp and BUILD/merged/compile_commands.json
"""

import json
import pathlib
import re
import sys


def merged(source: pathlib.Path) -> tuple[str, list[pathlib.Path]]:
    """The text of a source with the sources that it includes in their places, and the folders of these."""
    text, folders = [], []
    for line in source.read_text().splitlines():
        included = re.match(r'#include "(.*\.cpp)"', line)
        if not included:
            text.append(line)
            continue
        path = pathlib.Path(included[1])
        folders.append(path.parent)
        text += [f'#line 1 "{path}"', path.read_text()]
    return "\n".join(text) + "\n", folders


def main() -> None:
    build = pathlib.Path(sys.argv[1]).resolve()
    out = build / "merged"
    out.mkdir(exist_ok=True)
    project = pathlib.Path(__file__).resolve().parent.parent
    commands = []
    for entry in json.loads((build / "compile_commands.json").read_text()):
        source = pathlib.Path(entry["file"])
        if source.is_relative_to(build) and "Unity" not in source.parts:
            continue  # generated
        root = build if source.is_relative_to(build) else project
        file = out / (str(source.relative_to(root).with_suffix("")).replace("/", "_") + ".cpp")
        text, folders = merged(source)
        file.write_text(text)
        own = "".join(f" -I{folder}" for folder in dict.fromkeys([*folders, source.parent]))
        command = entry["command"].replace(f" -c {source}", f"{own} -c {file}")
        commands.append({**entry, "file": str(file), "command": command})
    (out / "compile_commands.json").write_text(json.dumps(commands))


if __name__ == "__main__":
    main()

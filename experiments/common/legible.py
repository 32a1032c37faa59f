#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the text of figures is legible in print: at least 6 pt high when a figure is as wide as it says (data-print-width).

Usage: legible.py FIGURE.svg..        Exit code 1: some text is smaller, or a figure does not say how wide it is.
"""
import math
import re
import sys
import xml.etree.ElementTree as xml

COLUMN, PAGE = 84.0, 177.0  # mm: a journal's column and page
SMALLEST = 6.0  # pt
POINT = 25.4 / 72.0  # mm
NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?"


def numbers(text):
    return [float(number) for number in re.findall(NUMBER, text)]


def length(text):
    """A length as its number and its unit."""
    found = re.fullmatch(rf"\s*({NUMBER})\s*([a-z%]*)\s*", text or "")
    return (float(found[1]), found[2]) if found else (math.nan, "")


def scale_of(element):
    """How much larger an element's inside is drawn than its outside."""
    scale = 1.0
    for name, values in re.findall(r"(\w+)\(([^)]*)\)", element.get("transform", "")):
        found = numbers(values)
        if name == "scale":
            scale *= math.sqrt(abs(found[0] * found[-1]))
        elif name == "matrix":
            scale *= math.sqrt(abs(found[0] * found[3] - found[1] * found[2]))
    if element.tag.endswith("}svg") and element.get("viewBox") and element.get("width"):
        scale *= length(element.get("width"))[0] / numbers(element.get("viewBox"))[2]
    return scale


def own_size(element):
    styled = re.search(rf"(?:font-size:|font:[^;]*?)\s*({NUMBER})px", element.get("style", ""))
    return float(styled[1]) if styled else length(element.get("font-size"))[0]


def texts(element, scale, size):
    """All texts below an element with their heights in its units."""
    own = own_size(element)
    size = size if math.isnan(own) else own
    if element.tag.endswith(("}text", "}tspan")) and (element.text or "").strip():
        yield element.text.strip(), size * scale
    for child in element:
        yield from texts(child, scale * scale_of(child), size)


def complaints(path):
    """What is wrong with a figure, a line each. Without text it may be as small as one likes."""
    root = xml.parse(path).getroot()
    found = list(texts(root, 1.0, 16.0))
    if not found:
        return []
    width, unit = length(root.get("data-print-width"))
    if unit != "mm" or not 0 < width <= PAGE:
        return [f"{path}: does not say how wide it is printed; valid is data-print-width=\"{COLUMN:g}mm\" (column) or \"{PAGE:g}mm\" (page)"]
    drawn = numbers(root.get("viewBox"))[2] if root.get("viewBox") else length(root.get("width"))[0]
    points = width / drawn / POINT
    return [f"{path}: '{words}' is {height * points:.2f} pt high in print; valid are {SMALLEST:g} pt or more"
            for words, height in found if not height * points >= SMALLEST]


def main():
    if len(sys.argv) < 2 or "--help" in sys.argv:
        print(__doc__.strip(), file=sys.stdout if "--help" in sys.argv else sys.stderr)
        raise SystemExit(0 if "--help" in sys.argv else 2)
    lines = [line for path in sys.argv[1:] for line in complaints(path)]
    print("\n".join(lines), end="\n" if lines else "", file=sys.stderr)
    raise SystemExit(1 if lines else 0)


if __name__ == "__main__":
    main()

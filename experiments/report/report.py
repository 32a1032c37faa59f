#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""One self-contained HTML page of a run of `make reproduce`: tables and figures, paper, ours, verdict, provenance.

Usage: report.py PROGRAM ROWS FIGURES OUTPUT.html
ROWS is the folder of the run: NAME.rows ("item | paper | ours | verdict") and the files that these were made from.
Each number of ours comes from a file of the run, and the page states the SHA-256 of that file.
"""
import base64
import hashlib
import html
import os
import pathlib
import re
import string
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
COLUMNS = 4
PAGE = 177.0  # mm: the width of a journal's page

# name of the experiment, its heading, and the files of the run that its rows were made from
TABLES = (
    ("table1_enumeration", "Table 1: filtering statistics", ("table1.csv",)),
    ("calibration_statistics", "Section 7.1: statistics of the calibration", ("library.db",)),
    ("table3_accuracy", "Table 3: accuracy of the reduced model", ("table3.csv",)),
)
# name of the file, what the paper's figure shows (in our words), and what ours shows
FIGURES = (
    ("fig02", "Fig. 2", "some of the generated patterns",
     "59 of the 1,824, drawn at random, each with its id, coloured by the number of edges; first the layout with its candidate edges"),
    ("fig05", "Fig. 5", "two graphs on the base triangle that differ in their radial edges and give one fan",
     "the same, on a pattern of ours, with the edges of each graph; the fans are compared in exact fractions"),
    ("fig06", "Fig. 6", "two graphs on the base triangle that differ in a node within a beam and give one shape",
     "the same, on a pattern of ours, with the edges of each graph; the shapes are compared in exact fractions"),
    ("fig07", "Fig. 7", "arrangements of seven hexagons for the rules on dangling edges, articulation points, components, valence and angles, the parts at fault in red",
     "a row for each rule: up to eight of the smallest graphs that break it alone, with id and reason, the beams at fault in red (none where a beam is missing); "
     "our rules also name crossings and missing interface nodes, and articulation covers dangling edges"),
    ("fig08", "Fig. 8", "patterns beside their reduced models, with interface nodes in green",
     "the same for six calibrated patterns, with id, the reduced model's twist theta and the calibration's error E"),
    ("fig10", "Fig. 10", "the five standard scenarios on a tile: axial, shear, bending, dome, saddle",
     "the same on the pattern 0-1+3-6: the tile at rest with supports and loads, and bent by the largest load, in true scale: the full model in grey, the reduced model in blue, "
     "with the largest displacement of each"),
    ("fig12", "Fig. 12", "example A: tiling and reduced model; setup; the bent reduced model in blue and the true one in grey",
     "(a) tiling, with a legend of its patterns, (b) the reduced model at rest, (c) setup, of many loads some, (d) the bent full model in grey and the reduced one in blue, "
     "with the largest displacement of each. Outline, painting, supports and loads are guessed"),
    ("fig13", "Fig. 13", "example B, as Fig. 12", "example B, as our Fig. 12. Outline, painting, supports and loads are guessed"),
    ("fig14", "Fig. 14", "example C, as Fig. 12", "example C, as our Fig. 12. Outline, painting, supports and loads are guessed"),
    ("fig15", "Fig. 15", "scans of two printed cantilevers in red, the patterns in dark grey, the reduced model in blue",
     "two cantilevers of the same size and material under their own weight, from the side: the full model as a grey band, the paper's reduced model (paper6) in blue, "
     "and further models; the patterns are guessed, and nothing was printed"),
)


class BadRun(SystemExit):
    """A file of the run is missing or not valid; the text is one line."""


def read_rows(path):
    """The rows of a file, without repeated headers."""
    if not path.is_file():
        raise BadRun(f"report.py: {path}: is missing; scripts/reproduce.sh makes it")
    rows = []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        cells = [cell.strip() for cell in line.split(" | ")] if " | " in line else [line]
        if cells[0] == "item":
            continue
        if len(cells) != COLUMNS:
            raise BadRun(f"report.py: {path}: line {number}: has {len(cells)} columns; valid are item | paper | ours | verdict")
        rows.append(cells)
    if not rows:
        raise BadRun(f"report.py: {path}: has no rows")
    return rows


def kind_of(verdict):
    """The colour of a verdict."""
    if verdict.startswith("DIFFERS"):
        return "differs"
    return "equal" if verdict.startswith(("equal", "same size")) else "other"


def sha256(path):
    if not path.is_file():
        raise BadRun(f"report.py: {path}: is missing; scripts/reproduce.sh makes it")
    digest = hashlib.sha256()
    with path.open("rb") as file:
        for block in iter(lambda: file.read(1 << 20), b""):
            digest.update(block)
    return digest.hexdigest()


def table_html(rows):
    lines = ["<table><thead><tr><th>item<th>paper<th>ours<th>verdict</tr></thead><tbody>"]
    for *cells, verdict in rows:
        lines.append("<tr>" + "".join("<td>" + html.escape(cell).replace(",", ",<wbr>") for cell in cells)
                     + f'<td class="{kind_of(verdict)}">{html.escape(verdict)}</tr>')
    return "\n".join(lines + ["</tbody></table>"])


def source_html(folder, name, files):
    hashes = "; ".join(f"<code>{file}</code> <span class=hash>{sha256(folder / file)}</span>" for file in files)
    return f"<p class=source>Made by <code>experiments/{name}/run.sh</code> from {hashes}.</p>"


def section_html(folder, name, heading, files):
    rows = read_rows(folder / f"{name}.rows")
    return f"<section><h2>{html.escape(heading)}</h2>\n{table_html(rows)}\n{source_html(folder, name, files)}</section>"


def print_width(data):
    """How wide a drawing is in print, mm, as it says; a page's width if it does not say."""
    said = re.search(rb'data-print-width="([0-9.]+)mm"', data)
    return float(said[1]) if said else PAGE


def figure_html(path, figure, paper, ours):
    """A drawing inside the page, as an image: its styles cannot touch the page's. It is larger than in print, by one factor for all."""
    digest = sha256(path)
    data = path.read_bytes()
    width = print_width(data)
    return (f'<figure><img style="width:{100 * width / PAGE:.0f}%" alt="{html.escape(f"{figure}: {ours}")}" src="data:image/svg+xml;base64,{base64.b64encode(data).decode()}">'
            f"<figcaption><b>{figure}.</b> <i>The paper's:</i> {html.escape(paper)}. <i>Ours</i> ({width:g} mm wide in print)<i>:</i> {html.escape(ours)}. "
            f"<span class=hash>{digest}</span></figcaption></figure>")


def summary_html(folder):
    verdicts = [kind_of(row[-1]) for name, *_ in TABLES for row in read_rows(folder / f"{name}.rows")]
    return (f"<p class=summary><b>{len(verdicts)}</b> rows: <b>{verdicts.count('equal')}</b> equal or of the same size, "
            f"<b>{verdicts.count('differs')}</b> that differ and must not, <b>{verdicts.count('other')}</b> with another verdict.</p>")


def page(program, folder, figures):
    version = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
    template = string.Template((HERE / "page.html").read_text())
    return template.substitute(
        version=html.escape(version.strip()), summary=summary_html(folder),
        tables="\n".join(section_html(folder, *table) for table in TABLES),
        figures="\n".join(figure_html(figures / f"{name}.svg", *texts) for name, *texts in FIGURES))


def write_atomically(path, text):
    handle, temporary = tempfile.mkstemp(dir=path.parent, prefix=path.name)
    try:
        with os.fdopen(handle, "w") as file:
            file.write(text)
        os.chmod(temporary, 0o644)
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise


def main():
    if len(sys.argv) != 5:
        print(__doc__.strip(), file=sys.stdout if "--help" in sys.argv else sys.stderr)
        raise SystemExit(0 if "--help" in sys.argv else 2)
    program, folder, figures, output = sys.argv[1], *map(pathlib.Path, sys.argv[2:])
    try:
        text = page(program, folder, figures)
    except BadRun as error:
        print(error, file=sys.stderr)
        raise SystemExit(2) from None
    write_atomically(output.resolve(), text)
    print(f"report: {output}")


if __name__ == "__main__":
    main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""datapackage.json of a release (specs.frictionlessdata.io), and its checksums."""
import hashlib
import json
import pathlib

from csv_tables import columns_of, read_rows

HERE = pathlib.Path(__file__).resolve().parent
LICENCE = {"name": "GPL-3.0-or-later", "title": "GNU General Public License v3.0 or later", "path": "https://www.gnu.org/licenses/gpl-3.0.html"}
ARCHIVES = {"arrays": "responses as NumPy arrays", "stiffness": "condensed stiffness and the tensors A, B and D as NumPy arrays"}


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def fields_of(table, columns):
    """One field a column; its type, unit and meaning are those of dictionary.csv."""
    meaning = {(row["table"], row["column"]): row for row in read_rows(HERE / "dictionary.csv")}
    for column in columns:
        row = meaning.get((table, column)) or meaning.get(("*", column))
        if row is None:
            raise SystemExit(f"dictionary.csv: has no row for column {column} of {table}.csv")
        yield {"name": column, "type": row["type"], "description": row["meaning"], "unit": row["unit"]}


def table_resource(path):
    return {"name": path.stem.replace("_", "-"), "path": f"tables/{path.name}", "profile": "tabular-data-resource", "format": "csv", "mediatype": "text/csv",
            "encoding": "utf-8", "schema": {"fields": list(fields_of(path.stem, columns_of(path)))}, "hash": f"sha256:{digest(path)}", "bytes": path.stat().st_size}


def archive_resource(path):
    return {"name": path.stem, "path": path.name, "profile": "data-resource", "format": "npz", "title": ARCHIVES[path.stem],
            "hash": f"sha256:{digest(path)}", "bytes": path.stat().st_size}


def data_package(folder, layout_name):
    tables = [table_resource(path) for path in sorted((folder / "tables").glob("*.csv"))]
    archives = [archive_resource(folder / f"{name}.npz") for name in ARCHIVES]
    return {"profile": "data-package", "name": f"fretwork-{layout_name.lower()}", "title": f"Patterns of the node layout {layout_name}",
            "licenses": [LICENCE], "resources": tables + archives}


def write_package(folder, layout_name):
    (folder / "datapackage.json").write_text(json.dumps(data_package(folder, layout_name), indent=1) + "\n")
    files = sorted(path for path in folder.rglob("*") if path.is_file() and path.name not in ("SHA256SUMS", "library.db"))
    (folder / "SHA256SUMS").write_text("".join(f"{digest(path)}  {path.relative_to(folder)}\n" for path in files))

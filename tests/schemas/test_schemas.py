# SPDX-License-Identifier: GPL-3.0-or-later
"""The JSON schemas of docs/schemas against the data files of the repository, and files that the program writes."""
import copy
import json
import os
import pathlib
import subprocess
import tempfile
import unittest
import warnings

import jsonschema

import studio_autosave

warnings.simplefilter("ignore", DeprecationWarning)  # RefResolver: newer releases have another way; Debian's has not

ROOT = pathlib.Path(os.environ["FRETWORK_SOURCE_DIR"])
PROGRAM = os.environ["FRETWORK_PROGRAM"]
SCHEMAS = {path.name.removesuffix(".schema.json"): json.loads(path.read_text())
           for path in (ROOT / "docs" / "schemas").glob("*.schema.json")}
STORE = {schema["$id"]: schema for schema in SCHEMAS.values()}

FRAME = {"format": "fretwork/frame/2", "nodes": [[0, 0, 0], [1, 0, 0]], "materials": {"m": {"young_modulus": 1e9, "poisson_ratio": 0.3, "density": 1000}},
         "sections": {"s": {"type": "I", "width": 0.1, "height": 0.1, "flange_thickness": 0.01, "web_thickness": 0.01}},
         "beams": [{"nodes": [0, 1], "section": "s", "material": "m"}], "supports": [{"node": 0, "fixed": ["ux", "uy", "uz", "rx", "ry", "rz"]}],
         "loads": [{"node": 1, "force": [0, 0, -1]}]}
PAINTING = {"format": "fretwork/painting/1", "layout": "paper7", "patterns": ["0-1+1-6"], "tiles": [0]}
RED = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 200 200" width="200mm" height="200mm"><rect width="200" height="200" fill="red"/></svg>'
CIRCLE = {"circle": {"center": [0.1, 0.1], "radius": 0.05}}
CIRCLE_CASE = {"format": "fretwork/load-case/4", "name": "push", "supports": [{**CIRCLE, "fixed": ["uz"]}], "loads": [{**CIRCLE, "force": [0, 0, -1]}, {**CIRCLE, "per_area": [0, 0, -1]}],
               "prescribed": [{**CIRCLE, "ux": 0.001}]}
CIRCLE_TARGET = {"format": "fretwork/target/2", "goals": [{"select": CIRCLE, "displacement": [None, None, 0.01]}]}
CIRCLE_STAGES = {"format": "fretwork/stages/2", "stages": [{"name": "clip", "keep": [{**CIRCLE, "fixed": ["uz"]}], "prescribed": [{**CIRCLE, "uy": 0.001}]},
                                                             {"name": "let go", "free": [{**CIRCLE, "fixed": ["uz"]}]}]}
STAGES = {"format": "fretwork/stages/1", "stages": [{"name": "pull", "loads": [{"load_case": "cantilever", "factor": 1}]}]}
LAYOUT = {"format": "fretwork/layout/1", "name": "mine", "corners": False, "radial": ["0.25"], "face": [], "interface": ["1/2"]}
SETTING = {"format": "fretwork/setting/3", "material": {"young_modulus": 1e9, "poisson_ratio": 0.3, "density": 1000, "strength": 4e7},
           "section": {"area": 1e-6, "I2": 1e-13, "I3": 1e-13, "J": 1e-13, "shear_area2": 1e-6}, "tile_side": 0.026, "sides": 6,
           "scenarios": [{"use": "axial", "max_magnitude": 1}]}
COMBINATION = {"format": "fretwork/load-case/2", "name": "both", "gravity": [0, 0, -9.81], "combines": [{"load_case": "push", "factor": -1e6}],
               "loads": [{"side": "right", "force": [0, 0, -1], "moment": [1, 0, 0]}], "prescribed": [{"side": "left", "ux": 0, "rz": 0}]}
SQUARE = {"format": "fretwork/outline/1", "boundary": [[0, 0], [0.2, 0], [0.2, 0.2], [0, 0.2]]}
# A valid document, the place of one value, and values that program and schema both take, and both refuse.
EDITS = (
    (LAYOUT, "name", ["a-B_1"], ["", "a b"]),
    (LAYOUT, "corners", [], [True]),
    (LAYOUT, "radial/0", ["1/3", "0.3", "00.30", "01/03"], ["1/0", "-1/3", "1", ".3", "0.", "1.5", "0.3e0", 0.3]),
    (SETTING, "material/young_modulus", [1e18, 1e-12], [1.1e18, 1e-13, 0]),
    (SETTING, "material/strength", [1e18], [1e300]),
    (SETTING, "material/density", [0, 1e-12, 1e12], [1e-13, 1e13, -1]),
    (SETTING, "section/area", [1e-24, 1e24], [1e-25, 1e25]),
    (SETTING, "section/I2", [1e-48, 1e48], [1e-49, 1e49]),
    (SETTING, "section/shear_area2", [1e24], [1e25]),
    (SETTING, "tile_side", [1e-12, 1e12], [1e-13, 1e13]),
    (SETTING, "scenarios", [["dome"]], [[]]),
    (SETTING, "scenarios/0/max_magnitude", [1e-24, 1e18], [1e-25, 1e19]),
    (FRAME, "format", ["fretwork/frame/1"], ["fretwork/frame/3"]),  # sections of type I are read under both numbers
    (FRAME, "nodes/1/0", [10], [1e13]),
    (FRAME, "beams", [], [[]]),
    (FRAME, "beams/0/divisions", [1, 1000], [0, 1001]),
    (FRAME, "materials/m/young_modulus", [1e18], [1e19]),
    (FRAME, "materials/unused", [], [{"young_modulus": 1e300, "poisson_ratio": 0.3}]),
    (FRAME, "sections/s/width", [0.2], [1e13]),
    (FRAME, "loads/0/force/0", [1e18, -1e18], [1.1e18, -1.1e18]),
    (FRAME, "gravity", [[0, 0, 1e12]], [[0, 0, 1e13]]),
    (COMBINATION, "loads/0/force/2", [1e18], [-1.1e18]),
    (COMBINATION, "loads/0/moment/0", [1e30], [1.1e30]),
    (COMBINATION, "prescribed/0/ux", [1e12], [-1.1e12]),
    (COMBINATION, "prescribed/0/rz", [1e6], [1.1e6]),
    (COMBINATION, "gravity/2", [1e12], [1.1e12]),
    (COMBINATION, "combines/0/factor", [1e6], [1.1e6, -1.1e6]),
    (STAGES, "stages/0/loads/0/factor", [1e6, -1e6, 0], [1.1e6, -1e300]),
    (STAGES, "stages/0/keep", [[]], []),
    (STAGES, "stages/0/loads", [], [[]]),
    (PAINTING, "patterns", [["0-1+1-6", "0-5+5-6"]], [["0-1+1-6", "0-1+1-6"], []]),
    (SQUARE, "boundary/2", [[0.3, 0.3]], [[0.2, 1e13]]),
    ("project.json", "tessellation/tiles", [], [[]]),
    ("project.json", "tessellation/tiles/0/vertices", [], [[0, 1]]),
    ("project.json", "tessellation/vertices/0/0", [], [1e13]),
    ("project.json", "tessellation/tiles/0/pattern", [], [100000001]),
    ("recipes.json", "recipes/0", [], [{"field": "x", "palette": ["0-1+1-6"], "range": [0, 1], "tiles": [0]}]),
    ("tiles.json", "model_error_estimate/full_share", [0, 1], [-0.1, 1.1, 5]),
    ("tiles.json", "converged", [True], [False]),
    ("tiles.json", "termination", [], ["diverged"]),
    ("tiles.json", "iterations", [2147483647], [2147483648]),
    ("tiles.json", "displacements/0/0", [], [1e13]),
    ("tiles.json", "displacements/0/3", [], [1e7]),
    ("tiles.json", "subject/stages", [], [STAGES]),  # without their load cases
    ("beams.json", "beams/0/utilization", [None], [0.5]),
    ("beams_with_strength.json", "beams/0/utilization", [0.5], [None]),
    ("beams.json", "unknown_beams", [2147483647], [2147483648]),
    ("facts.json", "bars", [2147483647], [2147483648]),
    ("autosave.json", "tiles", [1 << 40], [(1 << 40) + 1]),
)


def kind_of(document):
    return document["format"].split("/")[1]


def validator(kind):
    schema = SCHEMAS[kind]
    return jsonschema.Draft202012Validator(schema, resolver=jsonschema.RefResolver(schema["$id"], schema, store=STORE))


def repository_documents():
    for folder in ("experiments", "tests"):
        for path in sorted((ROOT / folder).rglob("*.json")):
            document = json.loads(path.read_text())
            if isinstance(document, dict) and str(document.get("format", "")).startswith("fretwork/"):
                yield str(path.relative_to(ROOT)), document


def run(folder, *arguments):
    return subprocess.run([PROGRAM, *arguments], cwd=folder, capture_output=True, text=True)


def with_value(document, place, value):
    """A copy of a document with another value at a place such as "nodes/1/0"."""
    document = copy.deepcopy(document)
    *owners, last = (int(step) if step.isdigit() else step for step in place.split("/"))
    owner = document
    for step in owners:
        owner = owner[step]
    owner[last] = value
    return document


def accepted_by_program(documents):
    """The indices of those documents that `fretwork check` calls valid."""
    with tempfile.TemporaryDirectory() as name:
        for index, document in enumerate(documents):
            (pathlib.Path(name) / f"{index}.json").write_text(json.dumps(document))
        checked = run(name, "check", *(f"{index}.json" for index in range(len(documents))))
    return {int(line.split(".json: valid ")[0]) for line in checked.stdout.splitlines()}


def made_documents():
    """Files of the program, and those written here, which the program must find valid, too."""
    case = str(ROOT / "experiments" / "cases" / "cantilever.json")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for file, document in (("frame.json", FRAME), ("painting.json", PAINTING), ("stages.json", STAGES),
                               ("circle_case.json", CIRCLE_CASE), ("circle_target.json", CIRCLE_TARGET), ("circle_stages.json", CIRCLE_STAGES)):
            (folder / file).write_text(json.dumps(document))
        (folder / "square.json").write_text(json.dumps(SQUARE))
        (folder / "red.svg").write_text(RED)
        commands = (("solve", "frame.json", "--steps", "2", "--modes", "1", "--buckling", "1", "--out", "frame_result.json"),
                    ("tile", "square.json", "--patterns", "0-1+1-6", "--edge-length", "40mm", "--out", "project.json"),
                    ("paint", "project.json", "--tiles", "0", "--patterns", "random:1", "--palette", "0-1+1-6=2,0-5+5-6", "--out", "recipes.json"),
                    ("paint", "recipes.json", "--tiles", "1", "--patterns", "field:u", "--palette", "0-1+1-6,0-5+5-6", "--property", "bending_stiffness", "--range", "0,0.1", "--dither"),
                    ("paint", "recipes.json", "--tiles", "2", "--patterns", "colours:red.svg", "--palette", "red=0-5+5-6"),
                    ("case", "add", "project.json", case),
                    ("simulate", "project.json", "--case", "cantilever", "--model", "full", "--steps", "2", "--out", "full.json"),
                    ("simulate", "project.json", "--case", "cantilever", "--model", "corotational", "--estimate-model-error", "--out", "tiles.json"),
                    ("simulate", "project.json", "--case", "cantilever", "--model", "condensed", "--linear", "--modes", "1", "--out", "linear.json"),
                    ("beams", "project.json", "tiles.json", "--out", "beams.json"),
                    ("beams", "project.json", "tiles.json", "--strength", "40MPa", "--out", "beams_with_strength.json"),
                    ("export", "project.json", "--content", "facts", "--to", "facts.json"),
                    ("export", "project.json", "--content", "facts", "--case", "cantilever", "--result", "full.json", "--clearance", "5mm", "--to", "facts_of_result.json"))
        for command in commands:
            done = run(folder, *command)
            if done.returncode != 0:
                raise AssertionError(f"{' '.join(command)}: {done.stderr}")
        (folder / "autosave.json").write_text(studio_autosave.autosave_of(PROGRAM, folder / "project.json", folder / "state"))
        files = sorted(folder.glob("*.json"))
        checked = run(folder, "check", *(file.name for file in files))
        if checked.returncode != 0:
            raise AssertionError(checked.stderr)
        return [(file.name, json.loads(file.read_text())) for file in files]


class Schemas(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.documents = [*repository_documents(), *made_documents()]

    def test_each_is_a_valid_schema(self):
        for schema in SCHEMAS.values():
            jsonschema.Draft202012Validator.check_schema(schema)

    def test_every_kind_has_a_document(self):
        self.assertEqual({kind_of(document) for _, document in self.documents}, set(SCHEMAS))

    def test_every_document_is_valid(self):
        for name, document in self.documents:
            errors = [f"{'/'.join(map(str, error.absolute_path))}: {error.message}" for error in validator(kind_of(document)).iter_errors(document)]
            self.assertEqual(errors, [], name)

    def test_a_circle_needs_its_format_and_a_radius(self):
        for document in (CIRCLE_CASE, CIRCLE_TARGET, CIRCLE_STAGES):
            check = validator(kind_of(document))
            self.assertTrue(check.is_valid(document), document["format"])
            kind, number = document["format"].rsplit("/", 1)
            for older in range(1, int(number)):
                self.assertFalse(check.is_valid({**document, "format": f"{kind}/{older}"}), f"{kind}/{older}")
            without = json.loads(json.dumps(document).replace("0.05", "0"))
            self.assertFalse(check.is_valid(without), "radius 0")

    def test_program_and_schema_agree_about_limits(self):
        made = dict(self.documents)
        cases = []
        for start, place, good, bad in EDITS:
            document = made[start] if isinstance(start, str) else start
            cases.append((f"{document['format']} as it is", document, True))
            for values, is_good in ((good, True), (bad, False)):
                cases += [(f"{document['format']} {place}: {json.dumps(value)}", with_value(document, place, value), is_good) for value in values]
        accepted = accepted_by_program([document for _, document, _ in cases])
        for index, (name, document, is_good) in enumerate(cases):
            with self.subTest(name):
                self.assertEqual(index in accepted, is_good, "the program")
                self.assertEqual(validator(kind_of(document)).is_valid(document), is_good, "the schema")

    def test_an_integer_with_a_point_is_for_schemas_only(self):
        with_point = with_value(SETTING, "sides", 6.0)
        self.assertTrue(validator("setting").is_valid(with_point))
        self.assertEqual(accepted_by_program([SETTING, with_point]), {0})

    def test_an_unknown_key_is_refused_wherever_it_stands(self):
        for name, document in self.documents:
            check = validator(kind_of(document))
            for place, owner in objects_in(document):
                if place[-1:] in (["materials"], ["sections"]):  # their keys are names
                    continue
                owner["surprise"] = 1
                self.assertFalse(check.is_valid(document), f"{name}: {place}")
                del owner["surprise"]

    def test_a_missing_key_or_another_format_is_refused(self):
        for name, document in self.documents:
            check = validator(kind_of(document))
            for key in SCHEMAS[kind_of(document)]["required"]:
                less = {other: value for other, value in document.items() if other != key}
                self.assertFalse(check.is_valid(less), f"{name}: {key}")
            self.assertFalse(check.is_valid({**document, "format": document["format"].rsplit("/", 1)[0] + "/99"}), name)


def objects_in(value, place=()):
    """Objects of a document with their places; of a list the first and the last element stand for all."""
    if isinstance(value, dict):
        yield list(place), value
        for key, member in list(value.items()):
            yield from objects_in(member, (*place, key))
    elif isinstance(value, list) and value:
        for index in sorted({0, len(value) - 1}):
            yield from objects_in(value[index], (*place, index))


if __name__ == "__main__":
    unittest.main()

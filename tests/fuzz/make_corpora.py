# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples from which a fuzzer starts, made from those of the repository and by the program: make_corpora.py PROGRAM

Files are small, because a fuzzer tries many. What a fuzzer found (found_*) stays."""
import base64
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
CORPORA = ROOT / "tests" / "fuzz" / "corpora"
EXPERIMENTS = ROOT / "experiments"
DATA = ROOT / "tests" / "outlines" / "data"


def put(reader, name, content):
    folder = CORPORA / reader
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())


def put_file(reader, path, name=None):
    put(reader, name or path.stem, path.read_bytes())


def put_json(reader, name, document):
    put(reader, name, json.dumps(document))


SVG = """<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="200mm" height="8in" viewBox="0 0 200 200" preserveAspectRatio="xMinYMax">
<!DOCTYPE_IS_NO_ELEMENT/><style>@media screen{.a>path,#b:first-child{fill:#f00!important;fill-rule:evenodd}} g *{stroke:none}</style>
<defs><clipPath id="c"><rect width="90" height="90"/></clipPath><symbol id="s"><circle r="9"/></symbol></defs>
<g class="a" transform="translate(10,10) rotate(5 1 1) scale(.9) matrix(1 0 .1 1 0 0) skewX(3)"><path id="b" d="M0 0h80v80H0z m10 10l5 5-5 5zC90 0 90 9 80 9S70 20 60 20Q50 50 40 40T30 30A9 5 30 1 0 20 20Z"/></g>
<polygon points="100,100 150,100 150,150"/><ellipse cx="120" cy="30" rx="20" ry="1cm" style="fill:rgb(10%,0,0)"/><use xlink:href="#s" x="50" y="150"/><rect x="150" y="150" width="40" height="40" rx="5" clip-path="url(#c)"/>
</svg>"""

DXF_ENTITIES = {
    "circle": [(0, "CIRCLE"), (10, 0), (20, 0), (40, 0.2)],
    "bulges": [(0, "LWPOLYLINE"), (90, 3), (70, 1), (10, 0), (20, 0), (42, 0.5), (10, 1), (20, 0), (10, 0.5), (20, 1)],
    "ellipse": [(0, "ELLIPSE"), (10, 0), (20, 0), (11, 1), (21, 0), (40, 0.5), (41, 0), (42, 6.283185307)],
    "lines": [(0, "LINE"), (10, 0), (20, 0), (11, 1), (21, 0), (0, "LINE"), (10, 1), (20, 0), (11, 0), (21, 1), (0, "ARC"), (10, 0), (20, 0), (40, 1),
              (50, 90), (51, 180), (0, "LINE"), (10, -1), (20, 0), (11, 0), (21, 0)],
    "spline": [(0, "SPLINE"), (70, 1), (71, 2), (72, 9), (73, 6), *[(40, k) for k in (0, 0, 0, 1, 2, 3, 4, 4, 4)],
               *[pair for x, y in ((0, 0), (1, 0), (1, 1), (0.5, 1.5), (0, 1), (0, 0)) for pair in ((10, x), (20, y))]],
}


def dxf(entities, before=()):
    pairs = [*before, (0, "SECTION"), (2, "ENTITIES"), *entities, (0, "ENDSEC"), (0, "EOF")]
    return "".join(f"{code}\n{value}\n" for code, value in pairs)


def drawings():
    for name in ("specimen", "example_a", "example_c"):
        put_file("svg", EXPERIMENTS / "outlines" / f"{name}.svg")
    put("svg", "most_features", SVG.replace("<!DOCTYPE_IS_NO_ELEMENT/>", ""))
    put_file("dxf", DATA / "slot.dxf")
    for name, entities in DXF_ENTITIES.items():
        put("dxf", name, dxf(entities))
    block = [(0, "SECTION"), (2, "BLOCKS"), (0, "BLOCK"), (2, "B"), (10, 0), (20, 0), *DXF_ENTITIES["circle"], (0, "ENDBLK"), (0, "ENDSEC")]
    put("dxf", "block", dxf([(0, "INSERT"), (2, "B"), (10, 1), (20, 1), (41, 2), (42, 2), (50, 30)], block))
    put_file("obj", DATA / "square_with_window.obj")
    put("obj", "slashes", "# a comment\no part\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\ng a\nf 1/1/1 2/1/1 3//1\nf -4 -2 -1\n")
    put_file("ply", DATA / "quadrilateral.ply")
    header = "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    put("ply", "ascii", header.replace("binary_little_endian", "ascii") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
    put_file("off", DATA / "two_triangles.off")
    put("off", "quadrilateral", "OFF # one face\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n")
    put_file("outline", DATA / "frame.json")
    put_json("outline", "triangle", {"format": "fretwork/outline/1", "boundary": [[0, 0], [0.4, 0], [0, 0.3]]})


FRAME = {"format": "fretwork/frame/2", "nodes": [[0, 0, 0], [1, 0, 0], [1, 1, 0]], "materials": {"m": {"young_modulus": 1e9, "poisson_ratio": 0.3, "density": 1000}},
         "sections": {"s": {"type": "I", "width": 0.1, "height": 0.1, "flange_thickness": 0.01, "web_thickness": 0.01}, "r": {"type": "rectangle", "width": 0.1, "height": 0.1}},
         "beams": [{"nodes": [0, 1], "section": "r", "material": "m"}, {"nodes": [1, 2], "section": "r", "material": "m"}],
         "supports": [{"node": 0, "fixed": ["ux", "uy", "uz", "rx", "ry", "rz"]}], "loads": [{"node": 1, "force": [0, 0, -1], "moment": [0, 0.1, 0]}], "gravity": [0, 0, -9.81]}
RECIPES = [{"field": "sin(30*x)^2", "palette": ["0-1+1-6", "0-5+5-6"], "property": "bending_stiffness", "range": [0.02, 0.1], "dither": True, "tiles": [0]},
           {"image": {"name": "grey.png", "content_base64": "iVBORw0KGgo="}, "palette": ["0-1+1-6"], "tiles": [1]},
           {"drawing": {"name": "regions.svg", "content_base64": "PHN2Zz4="}, "colours": [["#ff0000", "0-1+1-6"]], "tiles": [2]},
           {"random": "1", "palette": ["0-1+1-6", "0-5+5-6"], "weights": [3, 1], "tiles": [3]}]
LOAD_CASES = {
    "cantilever": {"format": "fretwork/load-case/1", "name": "cantilever", "supports": [{"side": "left", "fixed": ["ux", "uy", "uz", "rx", "ry", "rz"]}],
                   "loads": [{"side": "right", "force": [0, 0, -0.005]}]},
    "circle": {"format": "fretwork/load-case/4", "name": "circle", "supports": [{"circle": {"center": [0.05, 0.05], "radius": 0.03}, "fixed": ["uz"]}]},
    "hang": {"format": "fretwork/load-case/1", "name": "hang", "gravity": [0, 0, -9.81]}}
TARGET = {"format": "fretwork/target/1", "name": "arc", "description": "half of a circle", "goals": [
    {"nodes": [0, 2], "displacements": [[None, None, 0.01], [0, 0, 0.02]], "weight": 2}, {"nodes": [1], "positions": [[0.1, 0.2, None]], "case": "hang"},
    {"select": {"side": "right"}, "displacement": ["0.1*x", None, "0.05*x^2"]}]}
SCENARIO = {"format": "fretwork/scenario/1", "name": "pull", "weight": 1, "max_magnitude": 2,
            "held": [{"interface_node": 0, "fixed": ["ux", "uy", "uz", "rx", "ry", "rz"]}], "loads": [{"interface_node": 3, "force": [0, 1, 0]}]}
PAINTING = {"format": "fretwork/painting/1", "layout": "paper7", "patterns": ["0-1+1-6", "0-5+5-6"], "tiles": [0, 1, 1]}
STAGES = {"format": "fretwork/stages/1", "stages": [{"name": "pull", "loads": [{"load_case": "cantilever", "factor": 1}]}, {"name": "more", "loads": [{"load_case": "hang", "factor": 0.5}]}]}


def run(folder, *arguments):
    subprocess.run([PROGRAM, *map(str, arguments)], cwd=folder, check=True, capture_output=True)


def made_by_the_program(folder):
    """A surface of few tiles, its results, and the frame of its bars."""
    (folder / "square.json").write_text(json.dumps({"format": "fretwork/outline/1", "boundary": [[0, 0], [0.12, 0], [0.12, 0.1], [0, 0.1]]}))
    (folder / "small.json").write_text(json.dumps(FRAME))
    run(folder, "tile", "square.json", "--edge-length", "26mm", "--patterns", "0-1+1-6", "--out", "p.json")
    for name in ("cantilever", "own_weight"):
        run(folder, "case", "add", "p.json", EXPERIMENTS / "cases" / f"{name}.json")
    run(folder, "simulate", "p.json", "--case", "cantilever", "--model", "corotational", "--out", "r.json")
    run(folder, "solve", "small.json", "--modes", "1", "--deck", "small.inp", "--out", "fr.json")
    run(folder, "beams", "p.json", "r.json", "--strength", "40MPa", "--out", "b.json")
    run(folder, "export", "p.json", "--content", "facts", "--case", "own-weight", "--to", "facts.json")
    run(folder, "enumerate", "--layout", "faces5", "--edges", "2", "--library", "l.db")
    run(folder, "calibrate", "--library", "l.db", "--starts", "1")
    for reader, file in (("project", "p"), ("result", "r"), ("result", "fr"), ("facts", "facts")):
        put_file(reader, folder / f"{file}.json", "made_" + file)
    beams = json.loads((folder / "b.json").read_text())
    put_json("beams", "made_two", {**beams, "beams": beams["beams"][:2]})
    put_file("deck", folder / "small.inp", "made")
    put_file("library", folder / "l.db", "calibrated")
    project = json.loads((folder / "p.json").read_text())
    put_json("project", "recipes", {**project, "format": "fretwork/project/4", "recipes": RECIPES})
    put_json("autosave", "changed", {"format": "fretwork/autosave/1", "name": "square", "document": None, "tiles": len(project["tessellation"]["tiles"]), "project": project})


def documents():
    put_json("frame", "l_shaped", FRAME)
    for name in ("paper7", "faces5", "quarters10"):
        put_file("layout", EXPERIMENTS / "layouts" / f"{name}.json")
    for name, load_case in LOAD_CASES.items():
        put_json("load-case", name, load_case)
    for name in ("arch", "bridge", "example_b"):
        put_file("load-case", EXPERIMENTS / "cases" / f"{name}.json")
    put_json("painting", "three_tiles", PAINTING)
    put_json("scenario", "pull", SCENARIO)
    for name in ("bending", "dome"):
        put_file("scenario", EXPERIMENTS / "scenarios" / f"{name}.json")
    for name in ("paper", "made", "pla"):
        put_file("setting", EXPERIMENTS / "settings" / f"{name}.json")
    put_json("setting", "with_own_scenario", {"format": "fretwork/setting/2", "tile_side": 0.02, "joints": "stiff"})
    put_json("stages", "two", STAGES)
    put_json("target", "all_goals", TARGET)
    put_file("target", EXPERIMENTS / "targets" / "bow.json")
    put("deck", "general", "*HEADING\n*NODE, NSET=ALL\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 2., 0., 0.\n*ELEMENT, TYPE=B32R, ELSET=E\n1, 1, 2, 3\n*MATERIAL, NAME=M\n*ELASTIC\n"
        "1E9, 0.3\n*DENSITY\n1000.\n*BEAM SECTION, ELSET=E, MATERIAL=M, SECTION=RECT\n0.1, 0.2\n0., 1., 0.\n*BOUNDARY\n1, 1, 6\n*STEP, NLGEOM\n*STATIC\n*CLOAD\n3, 3, -1.\n*END STEP\n")


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(width, height, depth, colour, rows, more=b""):
    data = zlib.compress(b"".join(b"\0" + row for row in rows))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, depth, colour, 0, 0, 0)) + more + chunk(b"IDAT", data) + chunk(b"IEND", b"")


def images():
    put("image", "grey", png(4, 2, 8, 0, [bytes([0, 80, 160, 255])] * 2))
    put("image", "colour_and_alpha", png(2, 2, 16, 6, [bytes(range(16))] * 2))
    put("image", "palette", png(4, 1, 2, 3, [bytes([0b00011011])], chunk(b"PLTE", bytes(range(12))) + chunk(b"tRNS", b"\x80")))


def typed():
    for name, text in (("gradient", "(x-0.02)*20+(y-0.01)*4"), ("choice", "u > 0.5 ? sin(2*pi*v) : abs(x)^0.5")):
        put("expression", name, text)
    for name, text in (("range", "bending_stiffness between 0.07 and 0.09 and bending_poisson < 0"), ("set", "edges in (2, 3) or not mass_per_area >= 0.1"),
                       ("call", "abs(bending_poisson) > 0.1 and pattern_id like '0-%'")):
        put("query", name, text)


def messages():
    setting = {"format": "fretwork/setting/2", "tile_side": 0.02, "joints": "stiff"}
    edits = ({"do": "paint", "tiles": [0, 3], "pattern": "0-6"}, {"do": "paint", "patterns": ["0-6"] * 6}, {"do": "paint", "patterns": "random:7", "palette": "0-1+1-6=3,0-5+5-6", "tiles": [1]},
             {"do": "paint", "patterns": "field:(x-0.02)*20", "palette": "0-6,0-1+1-6", "dither": True}, {"do": "turn", "tiles": [1], "by": 2, "merge": "k"},
             {"do": "set_model", "model": "corotational", "linear": True}, {"do": "set_tile_model", "tiles": [0], "model": "full"}, {"do": "set_setting", "setting": setting},
             {"do": "set_load_case", "index": 1, "load_case": {key: value for key, value in LOAD_CASES["hang"].items() if key != "format"}}, {"do": "set_load_case", "index": 0, "load_case": LOAD_CASES["cantilever"]})
    for number, edit in enumerate(edits):
        put_json("studio-edit", f"{edit['do']}_{number}", {"id": number, **edit})
    target = {"goals": TARGET["goals"][:1]}
    put_json("studio-design", "all_keys", {"id": 1, "do": "design", "target": target, "tiles": [0, 2], "palette": "0-6,0-1+1-6", "max_patterns": 2, "free": ["factor"],
                                           "seconds": 5, "solutions": 20, "seed": 3})
    content = base64.b64encode((EXPERIMENTS / "outlines" / "specimen.svg").read_bytes()).decode()
    put_json("studio-new", "drawing", {"id": 1, "do": "new", "outline": {"name": "specimen.svg", "text_base64": content, "part": "1", "width": 0.2}, "tile_size": 0.026,
                                       "patterns": "random:1", "palette": "0-1+1-6", "layout": "paper7", "tiles": "new"})
    put_json("studio-new", "example", {"id": 1, "do": "new", "example": "bridge"})
    for name, text in (("page", "/?token=0123456789abcdef"), ("export", "/export?token=a&to=a%20b.svg&scale=2&view=30,40&size=16x10"), ("host", "127.0.0.1:8080"),
                       ("origin", "http://localhost:8080")):
        put("studio-address", name, text)


def frame(opcode, payload, mask=b"\1\2\3\4", last=True):
    """One frame of a WebSocket, as a client sends it."""
    size = len(payload)
    head = bytes([opcode | (0x80 if last else 0), 0x80 | (size if size < 126 else 126)]) + (struct.pack(">H", size) if size >= 126 else b"")
    return head + mask + bytes(byte ^ mask[i % 4] for i, byte in enumerate(payload))


def wire():
    """What a browser sends: requests, and a WebSocket's frames after its handshake. The token is that of the reader."""
    get = "GET {} HTTP/1.1\r\nHost: 127.0.0.1:8080\r\n"
    upgrade = get.format("/socket?token=token") + ("Origin: http://127.0.0.1:8080\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                                                   "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n")
    put("studio-wire", "page", get.format("/?token=token") + "\r\n")
    put("studio-wire", "export", get.format("/export?token=token&to=a%20b.svg&scale=2") + "Accept: */*\r\n\r\n")
    put("studio-wire", "with_body", get.format("/?token=token").replace("GET", "POST") + "Transfer-Encoding: chunked\r\n\r\n3\r\nabc\r\n0\r\n\r\n")
    hello = json.dumps({"id": 1, "do": "hello", "protocol": 1}).encode()
    put("studio-wire", "messages", (upgrade + "\r\n").encode() + frame(1, hello) + frame(9, b"ping") + frame(1, hello * 4) + frame(8, struct.pack(">H", 1000) + b"bye"))
    put("studio-wire", "fragments", (upgrade + "Sec-WebSocket-Extensions: permessage-deflate\r\n\r\n").encode()
        + frame(1, hello[:9], last=False) + frame(10, b"") + frame(0, hello[9:], mask=b"\0\0\0\0") + frame(1, "\u00e4".encode()) + frame(2, b"\0\xff"))


def conversations():
    """Messages of a page to a studio, a line for each. FOLDER is where its project lies; it has six tiles and one load case."""
    load_case = {**LOAD_CASES["cantilever"], "loads": [{"side": "right", "force": [0, 0, -0.001]}]}
    target = {"goals": [{"select": {"side": "right"}, "displacement": [None, None, "0.01"]}]}
    own_layout = {"format": "fretwork/layout/1", "name": "mine", "center": True, "corners": False, "radial": ["1/3"], "face": [["3/10", "9/20", "1/4"]], "interface": ["1/2"]}
    talks = {
        "edits": [{"do": "undo"}, {"do": "hello", "protocol": 1, "fields": ["stress", "N"]}, {"do": "paint", "tiles": [0, 3], "pattern": "0-6"}, {"do": "turn", "tiles": [1], "by": 2},
                  {"do": "undo"}, {"do": "redo"}, {"do": "set_load_case", "index": 1, "load_case": load_case}, {"do": "select_load_case", "index": 0}, {"do": "remove_load_case", "index": 1},
                  {"do": "set_model", "model": "condensed"}, {"do": "show", "fields": []}, {"do": "download"}],
        "files": [{"do": "hello", "protocol": 1}, {"do": "paint", "tiles": [2], "pattern": "0-5+5-6"}, {"do": "save", "path": "FOLDER/other.json"}, {"do": "save"}, {"do": "folder", "endings": [".json"]},
                  {"do": "open", "path": "FOLDER/project.json", "discard": True}, {"do": "save", "path": "FOLDER/other.json", "replaces": "0"}, {"do": "recoverable"}, {"do": "recover", "key": "0"},
                  {"do": "forget", "key": "0"}, {"do": "upload", "name": "p.json", "text_base64": base64.b64encode(b'{"format": "fretwork/project/2"}').decode()}],
        "jobs": [{"do": "hello", "protocol": 1}, {"do": "solve", "model": "full"}, {"do": "path", "steps": 2}, {"do": "modes", "count": 2}, {"do": "buckling", "count": 1},
                 {"do": "compare", "model": "full"}, {"do": "cancel"}, {"do": "design", "target": target, "palette": "0-6,0-1+1-6", "solutions": 8, "seconds": 1}, {"do": "stop_design"}],
        "tiles": [{"do": "hello", "protocol": 1}, {"do": "paint", "patterns": "field:(x-0.02)*20", "palette": "0-6,0-1+1-6", "dither": True}, {"do": "retile", "tile_size": 0.03, "angle": 0.2, "preview": True},
                  {"do": "retile", "tile_size": 0.03, "angle": 0.2, "patterns": "0-6"}, {"do": "set_tile_model", "tiles": [0], "model": "full"}, {"do": "undo"}],
        "layouts": [{"do": "hello", "protocol": 1}, {"do": "open_layout", "from": "paper8"}, {"do": "save_layout", "layout": own_layout, "path": "FOLDER/mine.json"},
                    {"do": "open_layout", "from": "FOLDER/mine.json"}, {"do": "open_layout", "from": "FOLDER/project.json"}]}
    for name, talk in talks.items():
        put("studio-talk", name, "\n".join(json.dumps({"id": number, **message}) for number, message in enumerate(talk)))


if __name__ == "__main__":
    PROGRAM = str(pathlib.Path(sys.argv[1]).resolve())
    for old in CORPORA.glob("*/*"):
        if not old.name.startswith("found_"):
            old.unlink()
    drawings()
    documents()
    images()
    typed()
    messages()
    wire()
    conversations()
    with tempfile.TemporaryDirectory() as name:
        made_by_the_program(pathlib.Path(name))

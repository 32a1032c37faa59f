#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# By the command line, on an outline with holes where hardly two tiles are alike: a hidden painting of 24 patterns at random, and
# its design. Prints one row of CSV: outline, seed, tiles, largest displacement wanted (m), errors of the best single pattern
# and of the design (shares of it), their ratio, solutions, seconds.
# Usage: irregular.sh [PROGRAM] [OUTPUT FOLDER] [SEED] [OUTLINE] [FORCE, N]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "${1:-$here/../../build/release/apps/fretwork/fretwork}")
out=${2:-$here/../../out/inverse_design_irregular}
seed=${3:-1}
outline=${4:-example_a}
force=${5:-0.005}
mkdir -p "$out" && cd "$out"
rm -f project.json
"$program" enumerate --layout paper7 --list all.txt >log.txt
palette=$(python3 -c "import random; random.seed($seed); print(','.join(random.sample(open('all.txt').read().split(), 24)))")
"$program" tile "$here/../outlines/$outline.svg" --edge-length 26mm --out project.json >>log.txt 2>&1
sed "s/-0.005/-$force/" "$here/../cases/cantilever.json" >cantilever.json
"$program" case add project.json cantilever.json >>log.txt
cp project.json hidden.json
"$program" paint hidden.json --patterns "random:$seed" --palette "$palette" >>log.txt 2>&1
"$program" simulate hidden.json --case cantilever --model full --out hidden_full.json >>log.txt
python3 - <<'PYTHON'
import json
count = len(json.load(open("hidden.json"))["tessellation"]["interface_nodes"])
rows = [row[:3] for row in json.load(open("hidden_full.json"))["displacements"][:count]]
json.dump({"format": "fretwork/target/1", "goals": [{"nodes": list(range(count)), "displacements": rows}]}, open("target.json", "w"))
PYTHON
"$program" design project.json --target target.json --palette "$palette" --seed "$seed" --out designed.json --json >design.json
python3 - "$outline" "$seed" <<'PYTHON'
import json, math, sys
design = json.load(open("design.json"))
tiles = len(json.load(open("project.json"))["tessellation"]["tiles"])
largest = max(math.hypot(*row) for row in json.load(open("target.json"))["goals"][0]["displacements"])
error, uniform = design["error_mean"], design["error_best_uniform"]
print(",".join([*sys.argv[1:], str(tiles), f"{largest:.4f}", f"{uniform:.6f}", f"{error:.6f}", f"{error / uniform:.4f}",
                str(design["solutions"]), f"{design['seconds']:.1f}"]))
PYTHON

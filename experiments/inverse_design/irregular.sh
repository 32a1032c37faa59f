#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# By the command line, on a real outline where no two tiles are alike: a hidden painting of 24 patterns at random, and its design.
# Usage: irregular.sh [PROGRAM] [OUTPUT FOLDER] [SEED]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "${1:-$here/../../build/release/apps/fretwork/fretwork}")
out=${2:-$here/../../out/inverse_design_irregular}
seed=${3:-1}
mkdir -p "$out" && cd "$out"
rm -f project.json
"$program" enumerate --layout paper7 --list all.txt >log.txt
palette=$(python3 -c "import random; random.seed($seed); print(','.join(random.sample(open('all.txt').read().split(), 24)))")
"$program" tile "$here/../outlines/example_a.svg" --edge-length 26mm --out project.json >>log.txt
"$program" case add project.json "$here/../cases/cantilever.json" >>log.txt
cp project.json hidden.json
"$program" paint hidden.json --patterns "random:$seed" --palette "$palette" >>log.txt 2>&1
"$program" simulate hidden.json --case cantilever --model full --out hidden_full.json >>log.txt
python3 - <<'PYTHON'
import json
count = len(json.load(open("hidden.json"))["tessellation"]["interface_nodes"])
rows = [row[:3] for row in json.load(open("hidden_full.json"))["displacements"][:count]]
json.dump({"format": "fretwork/target/1", "goals": [{"nodes": list(range(count)), "displacements": rows}]}, open("target.json", "w"))
PYTHON
"$program" design project.json --target target.json --palette "$palette" --out designed.json

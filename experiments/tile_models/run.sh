#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Every reduced tile model beside the full one: prints the tables of README.md, and writes every single figure to scenarios.csv
# and surfaces.csv in the output folder.
# Usage: run.sh [PROGRAM] [OUTPUT FOLDER] [OPTIONS..]     such as --patterns 10 --repeats 1 for a quick look
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=${1:-$here/../../build/release/experiments/tile_models/tile_models}
out=${2:-$here/../../out/tile_models}
shift $(($# < 2 ? $# : 2))
mkdir -p "$out"
[[ -x $program ]] || "$here/../../scripts/build.sh" tile_models
"$program" --out "$out" "$@"
python3 "$here/tables.py" "$out" | tee "$out/tables.md"

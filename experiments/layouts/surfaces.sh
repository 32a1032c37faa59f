#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Every layout of this folder from patterns to a compared surface: a library of at most 48 of its patterns, calibrated; a
# surface painted with them; clamped at its left end and pressed down at its right, with every tile model.
# Usage: surfaces.sh path/to/fretwork [OUTPUT FOLDER]. Two minutes. Writes surfaces.csv and a picture NAME.png of each surface into this folder.
set -euo pipefail
fretwork=$(realpath "${1:?the fretwork program}")
here=$(cd "$(dirname "$0")" && pwd)
out=$(realpath -m "${2:-$here/../../out/layouts}")
mkdir -p "$out"
cd "$out"
for file in "$here"/*.json; do
  name=$(basename "$file" .json)
  rm -f "$name.db" "$name.json"
  every=()
  [[ $("$fretwork" enumerate --layout "$name" --count) -gt 20000 ]] && every=(--sample 48 --seed 1)
  "$fretwork" enumerate --layout "$name" "${every[@]}" --library "$name.db" >/dev/null
  "$fretwork" calibrate --library "$name.db" --patterns sample:48 --json >"$name-calibrations.json" || [[ $? -eq 1 ]]  # some failed
  "$fretwork" tile "$here/../outlines/example_a.svg" --edge-length 26mm --library "$name.db" --patterns random:1 --out "$name.json" \
    --json >"$name-tiles.json"
  for model in full paper6 condensed corotational; do
    "$fretwork" simulate "$name.json" --case "$here/../cases/cantilever.json" --model "$model" --out "$name-$model.json" \
      >/dev/null || [[ $? -eq 1 ]]  # 1: not converged, a row without a value
  done
  rm -f "$name"-*-compared.json
  for model in paper6 condensed corotational; do
    "$fretwork" compare "$name-full.json" "$name-$model.json" --json >"$name-$model-compared.json" 2>/dev/null ||
      rm "$name-$model-compared.json"
  done
  "$fretwork" export "$name.json" --result "$name-full.json" --to "$here/$name.png" --size 480x300 >/dev/null
done
python3 "$here/surfaces.py" "$out" "$here/surfaces.csv"
cat "$here/surfaces.csv"

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The paper's figures 2, 5 to 8, 10 and 12 to 15, drawn from patterns, calibrations and simulations: out/figures/figNN.svg. Two minutes.
# Usage: run.sh [PROGRAM] [OUTPUT FOLDER]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
fretwork=$(realpath "${1:-$here/../../build/release/apps/fretwork/fretwork}")
out=$(realpath -m "${2:-$here/../../out/figures}")
mkdir -p "$out"
cd "$out"
"$fretwork" enumerate --svg fig02.svg --sample 59 >/dev/null
python3 "$here/duplicates.py" "$here/../layouts/paper7.json" .
"$fretwork" enumerate --edges 2..3 --svg fig07.svg --reasons >/dev/null
rm -f library.db
"$fretwork" enumerate --library library.db >/dev/null
"$fretwork" calibrate --library library.db --patterns sample:24 >/dev/null
"$fretwork" library export --library library.db --svg fig08.svg --patterns sample:6 >/dev/null
"$fretwork" library show 0-1+3-6 --library library.db --scenarios fig10.svg >/dev/null
for figure in 12:a:bridge 13:b:example_b 14:c:example_c; do
  IFS=: read -r number example case <<<"$figure"
  "$fretwork" tile "$here/../outlines/example_$example.svg" --library library.db --patterns random:1 --out "$example.json" >/dev/null
  "$fretwork" case add "$example.json" "$here/../cases/$case.json" --replace >/dev/null
  for model in full paper6; do
    "$fretwork" simulate "$example.json" --case "${case//_/-}" --model "$model" --out "${example}_$model.json" >/dev/null
  done
  "$fretwork" export "$example.json" --case "${case//_/-}" --result "${example}_full.json" \
    --result "${example}_paper6.json" --to "fig$number.svg" >/dev/null
done
"$here/../physical_test/run.sh" "$fretwork" "$out/physical_test" >/dev/null
cp "$out/physical_test/figure.svg" fig15.svg
python3 "$here/../common/legible.py" "$out"/fig*.svg
ls "$out"/fig*.svg

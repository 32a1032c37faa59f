#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Strips of seven tiles, five patterns: all 78,125 paintings for a hundred targets, and the search beside them. The
# enumeration takes some minutes for each of four palettes and is kept. Usage: small.sh [FOLDER OF PROGRAMS] [OUTPUT FOLDER]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "${1:-$here/../../build/release/experiments/inverse_design}")/inverse_design_small
out=${2:-$here/../../out/inverse_design_small}
mkdir -p "$out"
# Palette (seed) and number of targets.
for palette in 1:10 2:10 3:40 4:40; do
  seed=${palette%:*} targets=${palette#*:}
  [ -s "$out/best_$seed.csv" ] || { "$program" --enumerate --targets "$targets" --seed "$seed" >"$out/part" && mv "$out/part" "$out/best_$seed.csv"; }
  "$program" --targets "$targets" --seed "$seed" >"$out/found_$seed.csv"
done
cat "$out"/best_*.csv >"$out/rows_small_best.csv"
cat "$out"/found_*.csv >"$out/rows_small_found.csv"
python3 "$here/small.py" "$out/rows_small_best.csv" "$out/rows_small_found.csv" | tee "$out/small.md"

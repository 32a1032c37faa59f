#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Lower bounds beside the best of all paintings: rows_bounds.csv and a table. Usage: bounds.sh [FOLDER OF PROGRAMS] [OUTPUT FOLDER]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "${1:-$here/../../build/release/experiments/inverse_design}")/inverse_design_numbers
out=${2:-$here/../../out/inverse_design_bounds}
mkdir -p "$out"
echo "tiles,patterns,seed,target,uniform,best,one,per_tile,per_part,per_interval" >"$out/rows_bounds.csv"
for seed in 1 2 3; do
  for tiles in 2 3 4; do
    "$program" --patterns 5 --seed "$seed" --json | python3 "$here/bounds.py" --tiles $tiles --targets 4 --seed "$seed" >>"$out/rows_bounds.csv"
  done
done
python3 - "$out/rows_bounds.csv" <<'PYTHON' | tee "$out/bounds.md"
import collections, csv, statistics, sys
groups = collections.defaultdict(list)
for row in csv.DictReader(open(sys.argv[1])):
    groups[row["tiles"]].append(row)
print("| tiles | targets | best over best uniform | one multiplier | one a tile | one a part of a tile | one a tile and interval, six intervals |\n|---|---|---|---|---|---|---|")
for tiles, rows in groups.items():
    shares = [[float(row[c]) / float(row["best"]) for row in rows] for c in ("one", "per_tile", "per_part", "per_interval")]
    gain = statistics.median(float(row["best"]) / float(row["uniform"]) for row in rows)
    text = " | ".join(f"{statistics.median(s):.2g} ({min(s):.2g} to {max(s):.2g})" for s in shares)
    print(f"| {tiles} | {len(rows)} | {gain:.2g} | {text} |")
PYTHON

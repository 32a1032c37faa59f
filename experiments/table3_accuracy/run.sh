#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Tile three shapes of the sizes of the paper's examples, simulate them with every beam and with the reduced models, and print the
# errors relative to the largest displacement and rotation: "item | paper | ours | verdict". Usage: run.sh [PROGRAM] [OUTPUT FOLDER]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=${1:-$here/../../build/release/apps/fretwork/fretwork}
out=${2:-$here/../../out/reproduce}
mkdir -p "$out"
library=$out/table3.db   # of its own: the palette is what is calibrated in it

"$program" enumerate --layout paper7 --library "$library" >/dev/null
"$program" calibrate --library "$library" --patterns sample:24 >/dev/null
declare -A cases=([A]=bridge [B]=example_b [C]=example_c)
rm -f "$out/table3.csv"
for example in A B C; do
  lower=${example,,}
  "$program" tile "$here/../outlines/example_$lower.svg" --patterns random:1 --library "$library" --out "$out/$lower.json" >/dev/null
  for model in full paper6 condensed; do
    "$program" simulate "$out/$lower.json" --case "$here/../cases/${cases[$example]}.json" --model "$model" \
      --out "$out/${lower}_$model.json" >/dev/null
  done
  for model in paper6 condensed; do
    "$program" compare "$out/${lower}_full.json" "$out/${lower}_$model.json" --name "$example $model" >"$out/row.csv"
    [[ -e $out/table3.csv ]] && sed -i 1d "$out/row.csv"
    cat "$out/row.csv" >>"$out/table3.csv"
  done
done
rm -f "$out/row.csv"

awk -F, -v verdict="not comparable: own shape and loads" '
  FNR == 1 { next }
  NR == FNR { paper_u[$1] = $5 / $4; paper_r[$1] = $9 / $8; next }
  { split($1, name, " ")
    is_papers = name[2] == "paper6"   # the paper has no condensed tiles
    printf "Example %s, %s, largest error / largest displacement | %s | %.3f | %s\n", name[1], name[2],
           is_papers ? sprintf("%.3f", paper_u[name[1]]) : "-", $5 / $4, verdict
    printf "Example %s, %s, largest error / largest rotation | %s | %.3f | %s\n", name[1], name[2],
           is_papers ? sprintf("%.3f", paper_r[name[1]]) : "-", $9 / $8, verdict
  }' "$here/published.csv" "$out/table3.csv"

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Designs with forty solutions: ten hidden paintings of each kind. rows.csv (kept here as rows_40.csv) and a table; goes
# on where it was stopped.
# Usage: forty.sh [PROGRAM] [OUTPUT FOLDER]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "${1:-$here/../../build/release/experiments/inverse_design/inverse_design}")
out=${2:-$here/../../out/inverse_design_40}
mkdir -p "$out/rows"

row() {
  local file="$out/rows/$1.csv"
  shift
  [ -s "$file" ] && return
  "$program" --solutions 40 "$@" >"$file.part" && mv "$file.part" "$file"
}

for seed in $(seq 1 10); do
  for hidden in graded patchy; do
    row "44_${hidden}_$seed" --columns 11 --rows 4 --hidden $hidden --patterns 24 --seed "$seed"
    row "128_${hidden}_$seed" --columns 16 --rows 8 --hidden $hidden --patterns 24 --seed "$seed"
  done
done
python3 "$here/tables.py" "$out/rows" | tee "$out/tables.md"

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Designs for hidden paintings and arcs, and the same by other searches: rows.csv and tables. Goes on where it was
# stopped. Usage: run.sh [PROGRAM] [OUTPUT FOLDER] [all|small]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "${1:-$here/../../build/release/experiments/inverse_design/inverse_design}")
out=${2:-$here/../../out/inverse_design}
extent=${3:-all}
mkdir -p "$out/rows"

# A row is kept by its name.
row() {
  local file="$out/rows/$1.csv"
  shift
  [ -s "$file" ] && return
  "$program" "$@" >"$file.part" && mv "$file.part" "$file"
}

seeds="1 2 3 4 5"
[ "$extent" = small ] && seeds="1 2"
for seed in $seeds; do
  for hidden in graded patchy; do
    row "44_${hidden}_$seed" --columns 11 --rows 4 --hidden $hidden --patterns 24 --seed "$seed"
    for other in random greedy annealing; do
      row "44_${hidden}_${seed}_$other" --columns 11 --rows 4 --hidden $hidden --patterns 24 --seed "$seed" --baseline $other
    done
  done
done
for seed in $seeds; do
  for hidden in graded patchy; do
    row "128_${hidden}_$seed" --columns 16 --rows 8 --hidden $hidden --patterns 24 --seed "$seed"
  done
done
for seed in $(seq 1 20); do
  row "5_enumerate_$seed" --columns 5 --rows 1 --patterns 5 --share 0.3 --baseline enumerate --seed "$seed"
done
for seed in 1 2 3; do
  row "44_arc30_$seed" --columns 11 --rows 4 --angle 30 --share 0.26 --patterns all --seed "$seed"
  row "44_arc60_$seed" --columns 11 --rows 4 --angle 60 --share 0.5 --patterns all --seed "$seed"
  row "44_arc90_$seed" --columns 11 --rows 4 --angle 90 --share 0.72 --patterns all --seed "$seed"
  row "44_arc60free_$seed" --columns 11 --rows 4 --angle 60 --share 0.2 --free-factor --patterns all --seed "$seed"
done
for seed in 1 2 3; do
  row "200_graded_$seed" --columns 25 --rows 8 --hidden graded --patterns 64 --seed "$seed"
done
python3 "$here/tables.py" "$out/rows" | tee "$out/tables.md"

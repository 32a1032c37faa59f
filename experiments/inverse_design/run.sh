#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Designs for hidden paintings, arcs and other shapes, and the same by other searches: rows.csv and tables. Goes on where
# it was stopped. Usage: run.sh [FOLDER OF PROGRAMS] [OUTPUT FOLDER] [all|small]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
programs=$(realpath "${1:-$here/../../build/release/experiments/inverse_design}")
out=${2:-$here/../../out/inverse_design}
extent=${3:-all}
mkdir -p "$out/rows"

# A row is kept by its name.
row() {
  local file="$out/rows/$1.csv"
  local program="$programs/$2"
  shift 2
  [ -s "$file" ] && return
  "$program" "$@" >"$file.part" && mv "$file.part" "$file"
}
design() {
  local name=$1
  shift
  row "$name" inverse_design "$@"
}

ten=$(seq 1 10)
five=$(seq 1 5)
three="1 2 3"
two="1 2"
[ "$extent" = small ] && ten="1 2" five="1" three="1" two="1"
for seed in $ten; do
  for hidden in graded patchy; do
    design "44_${hidden}_$seed" --columns 11 --rows 4 --hidden $hidden --patterns 24 --seed "$seed"
  done
done
for seed in $ten; do
  for hidden in graded patchy; do
    design "128_${hidden}_$seed" --columns 16 --rows 8 --hidden $hidden --patterns 24 --seed "$seed"
  done
done
for seed in $five; do
  for hidden in graded patchy; do
    for other in table greedy annealing cmaes random; do
      design "44_${hidden}_${seed}_$other" --columns 11 --rows 4 --hidden $hidden --patterns 24 --seed "$seed" --baseline $other
    done
  done
done
for seed in $two; do
  for shape in field two two-tips arch dome; do
    row "${shape}_$seed" inverse_design_shapes --shape $shape --seed "$seed"
  done
  row "domefree_$seed" inverse_design_shapes --shape dome --free-factor --seed "$seed"
  for hidden in graded patchy; do
    design "128_${hidden}_${seed}_table" --columns 16 --rows 8 --hidden $hidden --patterns 24 --seed "$seed" --baseline table
  done
  design "200_graded_64_$seed" --columns 25 --rows 8 --hidden graded --patterns 64 --seed "$seed"
  design "200_graded_all_$seed" --columns 25 --rows 8 --hidden graded --patterns all --seed "$seed"
done
for hidden in graded patchy; do
  design "500_${hidden}_1" --columns 50 --rows 10 --hidden $hidden --patterns 24 --seed 1
done
for seed in $three; do
  design "200_linear_graded_$seed" --columns 25 --rows 8 --hidden graded --patterns 24 --share 0.01 --seed "$seed"
done
for seed in $two; do
  design "44_arc30_$seed" --columns 11 --rows 4 --angle 30 --share 0.26 --patterns all --seed "$seed"
  design "44_arc60_$seed" --columns 11 --rows 4 --angle 60 --share 0.5 --patterns all --seed "$seed"
  design "44_arc90_$seed" --columns 11 --rows 4 --angle 90 --share 0.72 --patterns all --seed "$seed"
  design "44_arc60free_$seed" --columns 11 --rows 4 --angle 60 --share 0.2 --free-factor --patterns all --seed "$seed"
done
design "200_linear_graded_1_table" --columns 25 --rows 8 --hidden graded --patterns 24 --share 0.01 --seed 1 --baseline table
[ "$extent" = small ] || design "2000_graded_1" --columns 100 --rows 20 --hidden graded --patterns 24 --seed 1
python3 "$here/tables.py" "$out/rows" | tee "$out/tables.md"

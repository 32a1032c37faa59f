#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Search the best known values of problems by all good methods: many starts of both calibrators, then whatever SLSQP, MLSL and
# CMA-ES find lower. Usage: search_known.sh PROGRAM OUT.csv FOLDER (--ids FILE | --patterns N) [--starts N]
# FOLDER keeps the runs: stopped, it goes on there. An hour of CPU time for all 1,824 patterns with 40 starts.
set -euo pipefail
[[ $# -ge 5 ]] || { sed -n 3,6p "$0" >&2; exit 2; }
program=$1 out=$2 folder=$3
shift 3
mkdir -p "$folder"
[[ -s $folder/known.csv ]] || "$program" optimizers known "$@" --out "$folder/known.csv"
run() { "$program" optimizers run --known "$folder/known.csv" --problems calibration --repetitions 1 --out "$folder/$1" "${@:2}"; }
run slsqp --optimizers slsqp:32
run mlsl --optimizers mlsl --budget 2500
run cma-es --optimizers cma-es --budget 6000
cp "$folder/known.csv" "$folder/better.csv"
for method in slsqp mlsl cma-es; do
  "$program" optimizers known --from "$folder/better.csv" --results "$folder/$method/results.csv" --out "$folder/next.csv"
  mv "$folder/next.csv" "$folder/better.csv"
done
cp "$folder/better.csv" "$out"

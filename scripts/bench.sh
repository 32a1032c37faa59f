#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Build and run the benchmarks. Usage: scripts/bench.sh [STAGE..]   (default: all). Figures go to build/bench/<stage>.json, too.
# REPETITIONS=3 runs each three times and prints mean, median and deviation.
set -euo pipefail
export OPENBLAS_NUM_THREADS=${OPENBLAS_NUM_THREADS:-1} OMP_NUM_THREADS=${OMP_NUM_THREADS:-1}  # one thread for yardsticks, too
cd "$(dirname "$0")/.."
cmake --preset bench >/dev/null
cmake --build --preset bench >/dev/null
for program in build/bench/bench/*_bench; do
  stage=$(basename "$program" _bench)
  if [[ $# -eq 0 || " $* " == *" $stage "* ]]; then
    "$program" --benchmark_repetitions="${REPETITIONS:-1}" --benchmark_out="build/bench/$stage.json" --benchmark_out_format=json
  fi
done

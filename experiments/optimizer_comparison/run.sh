#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Compare all optimizers on the calibration of the paper's model, and write tables, figures and report.html.
# Usage: run.sh [--subset | --all-patterns] [PROGRAM] [OUTPUT FOLDER]     Goes on where it was stopped. --subset takes about
# a minute on two free cores; the whole three hours of CPU time, an hour and a half on two free cores; --all-patterns, a few
# methods on every pattern, 40 minutes of CPU time (50 minutes passed on two busy cores).
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
part=everything
[[ ${1:-} != --* ]] || { part=${1#--}; shift; }
name=optimizer_comparison
known=$here/best_known.csv
runs=()
landscape=(--problems calibration:6 --descents 200)
case $part in
  everything) ;;
  subset)
    name+=_subset
    runs=(--problems calibration:3,synthetic:1,analytic:2 --repetitions 2 --budget 20000)
    landscape=(--problems calibration:2 --descents 50) ;;
  all-patterns)
    name+=_all_patterns
    known=
    runs=(--problems calibration --repetitions 1
      --optimizers gauss-newton-multistart,ceres-multistart,slsqp,simulated-annealing)
    landscape=() ;;
  *) echo "run.sh: unknown option --$part; there are --subset and --all-patterns" >&2; exit 2 ;;
esac
program=${1:-$here/../../build/release/apps/fretwork/fretwork}
out=${2:-$here/../../out/$name}
python=${PYTHON:-/usr/bin/python3}  # Debian's, which has SciPy and Matplotlib
"$python" -c 'import scipy, matplotlib' 2>/dev/null || {
  echo "run.sh: $python lacks SciPy or Matplotlib: apt-get install python3-scipy python3-matplotlib, or set PYTHON" >&2
  exit 2
}
mkdir -p "$out"
if [[ -z $known ]]; then
  known=$out/best_known.csv
  [[ -s $known ]] || "$program" optimizers known --patterns 1824 --starts 40 --out "$known"
fi
"$program" optimizers run --known "$known" "${runs[@]}" --out "$out"
if [[ $part == all-patterns ]]; then  # few starts searched so many patterns: what the runs found lower counts as known
  "$program" optimizers known --from "$known" --results "$out/results.csv" --out "$known.new"
  mv "$known.new" "$known"
fi
"$python" "$here/analyse.py" "$out/results.csv" "$known" "$out"
echo "The report is $out/report.html"
if [[ ${#landscape[@]} -gt 0 ]]; then
  "$program" optimizers landscape --known "$known" "${landscape[@]}" --out "$out"
  "$python" "$here/landscape.py" "$out" >/dev/null
  echo "The landscape is $out/landscape.html"
fi

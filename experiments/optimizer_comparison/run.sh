#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Compare all optimizers on the calibration of the paper's model, and write tables, figures and report.html.
# Usage: run.sh [--subset] [PROGRAM] [OUTPUT FOLDER]     Goes on where it was stopped; --subset takes about a minute
# on two free cores, the whole two hours.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
subset=()
landscape=(--problems calibration:6)
name=optimizer_comparison
if [[ ${1:-} == --subset ]]; then
  subset=(--problems calibration:3,synthetic:1,analytic:2 --repetitions 2 --budget 20000)
  landscape=(--problems calibration:2 --descents 50)
  name=optimizer_comparison_subset
  shift
fi
program=${1:-$here/../../build/release/apps/fretwork/fretwork}
out=${2:-$here/../../out/$name}
python=${PYTHON:-/usr/bin/python3}  # Debian's, which has SciPy and Matplotlib
"$python" -c 'import scipy, matplotlib' 2>/dev/null || {
  echo "run.sh: $python lacks SciPy or Matplotlib: apt-get install python3-scipy python3-matplotlib, or set PYTHON" >&2
  exit 2
}
mkdir -p "$out"
"$program" optimizers run --known "$here/best_known.csv" "${subset[@]}" --out "$out"
"$python" "$here/analyse.py" "$out/results.csv" "$here/best_known.csv" "$out"
"$program" optimizers landscape --known "$here/best_known.csv" "${landscape[@]}" --out "$out"
"$python" "$here/landscape.py" "$out" >/dev/null
echo "The reports are $out/report.html and $out/landscape.html"

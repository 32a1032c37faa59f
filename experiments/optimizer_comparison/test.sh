#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The measures on hand-counted cases, then a tiny comparison from runs to reports. Usage: test.sh PROGRAM
# Exit code 77, which says "skipped", where SciPy or Matplotlib is missing.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
python=${PYTHON:-/usr/bin/python3}
"$python" -c 'import scipy, matplotlib' 2>/dev/null || { echo "skipped: $python lacks SciPy or Matplotlib"; exit 77; }
"$python" -B "$here/test_measures.py"
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
"$1" optimizers run --known "$here/best_known.csv" --problems calibration:2,synthetic:1,analytic:1 --repetitions 1 --budget 300 \
  --optimizers gauss-newton-multistart,ceres-multistart,simulated-annealing,bobyqa --threads 1 --out "$out" >/dev/null
"$python" -B "$here/analyse.py" "$out/results.csv" "$here/best_known.csv" "$out" >"$out/verdicts.txt"
[[ $(wc -l <"$out/verdicts.txt") -eq 6 ]] || { echo "six verdicts were expected"; cat "$out/verdicts.txt"; exit 1; }
"$python" -B "$here/thin.py" "$out/results.csv" "$here/best_known.csv" "$out/thin.csv.gz"
"$python" -B "$here/analyse.py" "$out/thin.csv.gz" "$here/best_known.csv" "$out/thin" >"$out/thin.txt"
for table in verdicts final runtimes budgets tests synthetic analytic; do cmp "$out/$table.csv" "$out/thin/$table.csv"; done
"$1" optimizers landscape --known "$here/best_known.csv" --problems calibration:1 --descents 3 --threads 1 --out "$out" >/dev/null
"$python" -B "$here/landscape.py" "$out" >/dev/null
for file in report.html data_profile.svg data_profile_time.svg performance_profile.svg runtimes.svg final_gaps.svg convergence.svg tests.csv landscape.html; do
  [[ -s $out/$file ]] || { echo "$file is missing"; exit 1; }
done

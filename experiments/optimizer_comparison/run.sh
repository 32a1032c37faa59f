#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Compare optimizers on the calibration of the paper's model, and write tables, figures and report.html.
# Usage: run.sh [--subset | --held-out | --other-setting | --all-patterns | --annealing-raw] [PROGRAM] [OUTPUT FOLDER]     Goes on where it was stopped.
#   (nothing)       26 methods on 60 patterns, synthetic targets and analytic functions, and the landscape: 50 minutes of CPU time
#   --subset        the same on 3 patterns, 1 synthetic and 2 analytic problems: two minutes
#   --held-out      seven methods on 60 patterns on which nothing was tuned: five minutes
#   --other-setting eight methods on the held-out patterns in another setting (experiments/settings/flat.json): five minutes
#   --all-patterns  the three best on all 1,824 patterns: two minutes
#   --annealing-raw annealing of the quantities on all 1,824 patterns: 20 minutes of CPU time
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
part=everything
[[ ${1:-} != --* ]] || { part=${1#--}; shift; }
descents=ceres-multistart,gauss-newton-multistart,slsqp
known=$here/best_known.csv
name=optimizer_comparison_${part//-/_}
landscape=()
setting=()
# Of each entry one call: options of `optimizers run`. More repetitions of what costs little.
case $part in
  everything)
    name=optimizer_comparison
    runs=("--repetitions 3" "--repetitions 51 --problems calibration --optimizers $descents"
      "--repetitions 15 --problems analytic")
    landscape=(--problems calibration:6 --descents 200) ;;
  subset)
    runs=("--problems calibration:3,synthetic:1,analytic:2 --repetitions 2 --budget 20000")
    landscape=(--problems calibration:2 --descents 50) ;;
  held-out)
    known=$here/best_known_held_out.csv
    runs=("--repetitions 3 --optimizers $descents,mlsl,cma-es,differential-evolution,simulated-annealing"
      "--repetitions 15 --optimizers $descents") ;;
  other-setting)
    known=known.csv  # of the output folder, made there
    setting=(--setting "$here/../settings/flat.json")
    runs=("--repetitions 1 --optimizers $descents,mlsl,cma-es,differential-evolution,simulated-annealing,annealing-cool"
      "--repetitions 5 --optimizers $descents") ;;
  annealing-raw)
    known=$here/best_known_all_patterns.csv
    runs=("--repetitions 1 --optimizers annealing-raw") ;;
  all-patterns)
    known=$here/best_known_all_patterns.csv
    runs=("--repetitions 1 --optimizers $descents") ;;
  *) echo "run.sh: unknown option --$part; there are --subset, --held-out, --other-setting, --all-patterns and --annealing-raw" >&2; exit 2 ;;
esac
program=${1:-$here/../../build/release/apps/fretwork/fretwork}
out=${2:-$here/../../out/$name}
python=${PYTHON:-/usr/bin/python3}  # Debian's, which has SciPy and Matplotlib
"$python" -c 'import scipy, matplotlib' 2>/dev/null || {
  echo "run.sh: $python lacks SciPy or Matplotlib: apt-get install python3-scipy python3-matplotlib, or set PYTHON" >&2
  exit 2
}
mkdir -p "$out"
if [[ $part == other-setting ]]; then
  known=$out/known.csv
  sed 's/$/@flat/' "$here/held_out.txt" >"$out/ids.txt"
  [[ -s $known ]] || "$program" optimizers known --ids "$out/ids.txt" --starts 80 "${setting[@]}" --out "$known"
fi
for options in "${runs[@]}"; do
  # shellcheck disable=SC2086  # a list of words
  "$program" optimizers run --known "$known" $options ${setting[@]+"${setting[@]}"} --out "$out"
done
"$python" "$here/summary.py" "$known" "$out/results.csv" | tee "$out/summary.md"
if [[ $part == all-patterns || $part == annealing-raw ]]; then exit; fi  # analyse.py compares several methods with annealing
"$python" "$here/analyse.py" "$out/results.csv" "$known" "$out"
echo "The report is $out/report.html"
if [[ ${#landscape[@]} -gt 0 ]]; then
  "$program" optimizers landscape --known "$known" "${landscape[@]}" --out "$out"
  "$python" "$here/landscape.py" "$out" >/dev/null
  echo "The landscape is $out/landscape.html"
fi

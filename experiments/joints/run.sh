#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Regenerate solids, beams, tables and figure of README.md: an hour of one core, most of it CalculiX. Stopped, it goes on when started again.
# Usage: run.sh [PROGRAM] [OUTPUT FOLDER] [--only ID,..] [--widths 2] [--mesh 0.5 ..]    (one pattern: a minute; solids.py --help says all)
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "${1:-$here/../../build/release/apps/fretwork/fretwork}")
out=${2:-$here/../../out/joints}
python=${PYTHON:-/usr/bin/python3}  # Debian's, which has gmsh, NumPy and SciPy
"$here/tools.sh" "$python"
mkdir -p "$out"
export OMP_NUM_THREADS=${OMP_NUM_THREADS:-1}
"$python" -B "$here/solids.py" "$program" "$out" "${@:3}"
if [[ $# -le 2 ]]; then
  # Finer meshes and more layers on six patterns; fillets on the same.
  some=1-3+3-7,1-2+1-4+4-7,0-1+1-4+2-7,1-2+1-4+1-7+2-7,0-1+1-3+2-3+2-7+3-5+4-5+5-7,0-1+1-2+1-3+1-5+1-6+2-5+4-7+5-6+5-7+6-7
  for mesh in "--mesh 1" "--corner 0.25" "--mesh 0.25" "--layers 2" "--fillet 0.5" "--fillet 1"; do
    "$python" -B "$here/solids.py" "$program" "$out" --widths 2 --only "$some" $mesh
  done
fi
"$python" -B "$here/beams.py" "$program" "$out"
[[ $# -le 2 ]] || { cat "$out/rows.csv"; exit 0; }
"$python" -B "$here/bar_check.py" | tee "$out/bar_check.md"
"$python" -B "$here/analyse.py" "$out/rows.csv" "$out/figure.svg" | tee "$out/tables.md"
"$python" -B "$here/scan.py" "$program" "$out" | tee "$out/scan.md"

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# One bar against closed forms, and one stored pattern from its outline to its row. Usage: test.sh PROGRAM
# Exit code 77, which says "skipped", where gmsh, CalculiX, NumPy or SciPy is missing.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
python=${PYTHON:-/usr/bin/python3}
"$here/tools.sh" "$python" || exit 77
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
"$python" -B "$here/bar_check.py" --sizes 0.5 --layers 1 --most 0.03
"$here/run.sh" "$1" "$out" --only 1-3+3-7 --widths 2 >/dev/null
"$python" -B "$here/compare_rows.py" "$out/rows.csv" "$here/rows.csv"

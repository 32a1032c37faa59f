#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Solids and beams of 14 patterns that nothing was chosen on, bars of 2 mm: a minute of one core.
# Usage: unseen.sh [PROGRAM] [OUTPUT FOLDER]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "${1:-$here/../../build/release/apps/fretwork/fretwork}")
out=${2:-$here/../../out/joints_unseen}
python=${PYTHON:-/usr/bin/python3}
"$here/tools.sh" "$python"
"$here/run.sh" "$program" "$out" --only "$("$python" -B "$here/unseen.py" draw "$program" "$out")" --widths 2 >/dev/null
"$python" -B "$here/unseen.py" judge "$out/rows.csv" | tee "$out/unseen.md"

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Sheets of 60 patterns under five loads: the calibrated ring with links against the tiles that it stands for. Some minutes; goes on
# where it was stopped. Usage: run.sh [OUTPUT FOLDER] [PATTERNS] [FOLDER OF THE PYTHON MODULE]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
out=${1:-$here/../../out/objective_and_surfaces}
export PYTHONPATH=${3:-$here/../../build/release/apps/python}
/usr/bin/python3 "$here/run.py" "$out" --patterns "${2:-60}"
/usr/bin/python3 "$here/analyse.py" "$out/rows.csv" "$out/figure.svg" | tee "$out/tables.md"

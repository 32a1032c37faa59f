#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Sheets of 60 patterns under five loads: the calibrated ring with links against the tiles that it stands for. Ten minutes; goes on
# where it was stopped. Usage: run.sh [PROGRAM] [OUTPUT FOLDER] [PATTERNS]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "${1:-$here/../../build/release/apps/fretwork/fretwork}")
out=${2:-$here/../../out/objective_and_surfaces}
python3 "$here/run.py" "$program" "$out" --patterns "${3:-60}"
python3 "$here/analyse.py" "$out/rows.csv" "$out/figure.svg" | tee "$out/tables.md"

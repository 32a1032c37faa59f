#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Random painted surfaces under loads of all kinds: how far each model is from the full one, and how good the estimate of it is.
# Ten minutes; goes on where it was stopped. Usage: run.sh [PROGRAM] [OUTPUT FOLDER] [SURFACES]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "${1:-$here/../../build/release/apps/fretwork/fretwork}")
out=${2:-$here/../../out/large_deflections}
mkdir -p "$out"
"$program" enumerate --layout paper7 --list "$out/patterns.txt" >/dev/null
python3 "$here/run.py" "$program" "$out/patterns.txt" "$out" --count "${3:-126}"
python3 "$here/analyse.py" "$out/rows.csv" "$out/figure.svg" | tee "$out/tables.md"

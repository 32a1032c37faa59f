#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Stresses of the beams of corotational tiles, recovered in seven ways, against those of the full model. Some minutes.
# Usage: run.sh [PROGRAM] [OUTPUT FOLDER] [run.py's options]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$here/../../build/release
program=$(realpath "${1:-$build/apps/fretwork/fretwork}")
out=${2:-$here/../../out/recovered_stresses}
recoveries=$build/experiments/recovered_stresses/recovered_stresses
[[ -x $recoveries ]] || "$here/../../scripts/build.sh" recovered_stresses
mkdir -p "$out"
python3 -B "$here/run.py" "$program" "$recoveries" "$out" "${@:3}"
python3 -B "$here/tables.py" "$out/rows.csv" | tee "$out/tables.md"

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Do results of reduced models that are far off say so by themselves? Surfaces of 15 kinds under loads from small to far too large.
# Half an hour; goes on where it was stopped. Usage: run.sh [PROGRAM] [OUTPUT FOLDER] [rows.py's options]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "${1:-$here/../../build/release/apps/fretwork/fretwork}")
out=${2:-$here/../../out/error_warnings}
mkdir -p "$out"
if [[ ! -e "$out/library.db" ]]; then
  "$program" enumerate --layout paper7 --library "$out/library.db" >/dev/null
  "$program" calibrate --library "$out/library.db" --setting paper --patterns sample:40 >/dev/null
fi
"$program" enumerate --layout paper7 --list "$out/patterns.txt" >/dev/null
python3 -B "$here/rows.py" "$program" "$out" "${@:3}"
python3 -B "$here/analyse.py" "$out/rows.csv" | tee "$out/tables.md"

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# By what tiles could be ranked that are best put in full, on the cantilevers and bridges of run.sh. Five minutes.
# Usage: rankings.sh [PROGRAM] [OUTPUT FOLDER] [SURFACES]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$here/../../build/release
program=$(realpath "${1:-$build/apps/fretwork/fretwork}")
out=${2:-$here/../../out/large_deflections}
rankings=$build/experiments/large_deflections/large_deflection_rankings
mkdir -p "$out"
[[ -x $rankings ]] || "$here/../../scripts/build.sh" large_deflection_rankings
"$program" enumerate --layout paper7 --list "$out/patterns.txt" >/dev/null
python3 "$here/rankings.py" "$program" "$out/patterns.txt" "$out" --rankings "$(realpath "$rankings")" --count "${3:-126}"

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The effect of another objective: prints the table of README.md, and writes every calibration to
# objective_sensitivity.csv in the output folder.
# Usage: run.sh [PROGRAM] [OUTPUT FOLDER] [OPTIONS..]     such as --patterns 6 for a quick look
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=${1:-$here/../../build/release/experiments/objective_sensitivity/objective_sensitivity}
out=${2:-$here/../../out/objective_sensitivity}
shift $(($# < 2 ? $# : 2))
mkdir -p "$out"
[[ -x $program ]] || "$here/../../scripts/build.sh" objective_sensitivity
"$program" --out "$out/objective_sensitivity.csv" "$@" | tee "$out/table.md"

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The gain of each calibrator and number of starts: prints the table of README.md, and writes every single result to
# calibration_quality.csv in the output folder.
# Usage: run.sh [PROGRAM] [OUTPUT FOLDER] [OPTIONS..]     such as --patterns 6 --reference-starts 50 for a quick look
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=${1:-$here/../../build/release/experiments/calibration_quality/calibration_quality}
out=${2:-$here/../../out/calibration_quality}
shift $(($# < 2 ? $# : 2))
mkdir -p "$out"
[[ -x $program ]] || "$here/../../scripts/build.sh" calibration_quality
"$program" --out "$out/calibration_quality.csv" "$@" | tee "$out/table.md"

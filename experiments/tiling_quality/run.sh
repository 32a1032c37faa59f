#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Print a row of CSV for each outline: the figures of README.md. Usage: run.sh [BUILD FOLDER] [OUTLINES..]     Without outlines: the paper's three sizes.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=${1:-$here/../../build/release}/experiments/tiling_quality/tiling_quality
shift || true
[[ -x $program ]] || "$here/../../scripts/build.sh" tiling_quality
[[ $# -gt 0 ]] || set -- "$here"/../outlines/example_{a,b,c}.svg
"$program" --edge-length 0.0259808 "$@"

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Frames and surfaces that buckle smoothly or snap: do solutions at once end where many small steps end? Half a minute.
# Usage: run.sh [PROGRAM] [OUTPUT FOLDER]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "${1:-$here/../../build/release/apps/fretwork/fretwork}")
out=${2:-$here/../../out/smooth_paths}
mkdir -p "$out"
python3 "$here/frames.py" "$program" "$out" | tee "$out/frames.txt"
python3 "$here/surfaces.py" "$program" "$out" | tee "$out/surfaces.txt"

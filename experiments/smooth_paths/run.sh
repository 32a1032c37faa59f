#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Frames and surfaces that buckle smoothly or snap: do solutions at once end where many small steps end? Half a minute.
# Usage: run.sh [OUTPUT FOLDER] [FOLDER OF THE PYTHON MODULE]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
out=${1:-$here/../../out/smooth_paths}
export PYTHONPATH=${2:-$here/../../build/release/apps/python}
mkdir -p "$out"
/usr/bin/python3 "$here/frames.py" | tee "$out/frames.txt"
/usr/bin/python3 "$here/surfaces.py" | tee "$out/surfaces.txt"

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The paper's physical test, computed: half a minute. Usage: run.sh [PROGRAM] [OUTPUT FOLDER] [--measured SPECIMEN=FILE.csv ..]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "${1:-$here/../../build/release/apps/fretwork/fretwork}")
out=${2:-$here/../../out/physical_test}
python3 "$here/run.py" "$program" "$out" "${@:3}"

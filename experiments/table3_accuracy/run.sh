#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Tile three shapes of the sizes of the paper's examples, paint each three times, simulate them with every beam and with the reduced
# models, and print the errors relative to the largest displacement and rotation: "item | paper | ours | verdict".
# Usage: run.sh [PROGRAM] [OUTPUT FOLDER]. PAGE=1 prints the tables of README.md. A minute.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=${1:-$here/../../build/release/apps/fretwork/fretwork}
out=${2:-$here/../../out/reproduce}
python3 "$here/run.py" "$program" "$out" ${RELAXATION:+--relaxation}
python3 "$here/tables.py" "$out/table3.csv" ${PAGE:+--page}

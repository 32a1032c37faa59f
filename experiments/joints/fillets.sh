#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Solids of 20 patterns with fillets of 0, 0.5 and 1 mm, bars of 2 mm, beside beams with stiff joints: some minutes of one core.
# Usage: fillets.sh [PROGRAM] [OUTPUT FOLDER]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "${1:-$here/../../build/release/apps/fretwork/fretwork}")
out=${2:-$here/../../out/joints_fillets}
python=${PYTHON:-/usr/bin/python3}
export OMP_NUM_THREADS=${OMP_NUM_THREADS:-1}
"$here/tools.sh" "$python"
patterns=$("$python" -B "$here/fillets.py" draw "$program" "$out")
for fillet in 0 0.5 1; do
  "$python" -B "$here/solids.py" "$program" "$out" --widths 2 --only "$patterns" --fillet "$fillet"
done
"$python" -B "$here/fillets.py" judge "$program" "$out" | tee "$out/fillets.md"

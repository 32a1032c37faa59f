#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Regenerate Table 1 and print "item | paper | ours | verdict". Usage: run.sh [PROGRAM] [OUTPUT FOLDER]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=${1:-$here/../../build/release/apps/fretwork/fretwork}
out=${2:-$here/../../out/reproduce}
mkdir -p "$out"
"$program" enumerate --layout paper7 --census "$out/table1.csv" >/dev/null

# Row by row: the counts of each number of edges, the paper's and ours.
paste -d'|' "$here/expected.csv" "$out/table1.csv" | awk -F'|' '
  NR == 1 { print "Table 1 | " $1 " | the same | "; header_equal = ($1 == $2); next }
  { split($1, paper, ","); total_paper += paper[9]; split($2, ours, ","); total_ours += ours[9]
    printf "Table 1, %2d edges | %s | %s | %s\n", paper[1], $1, $2, ($1 == $2) ? "equal" : "DIFFERS" }
  END { printf "Table 1, valid patterns | %d | %d | %s\n", total_paper, total_ours,
               (total_paper == total_ours && header_equal) ? "equal" : "DIFFERS" }'
cmp -s "$here/expected.csv" "$out/table1.csv"

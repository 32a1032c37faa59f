#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# irregular.sh on four outlines with holes, three hidden paintings each: rows_outlines.csv and a table. Goes on where it was
# stopped. Usage: outlines.sh [PROGRAM] [OUTPUT FOLDER]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "${1:-$here/../../build/release/apps/fretwork/fretwork}")
out=${2:-$here/../../out/inverse_design_outlines}
mkdir -p "$out/rows"
while read -r outline force; do
  for seed in 1 2 3; do
    file="$out/rows/${outline}_$seed.csv"
    [ -s "$file" ] && continue
    "$here/irregular.sh" "$program" "$out/work_${outline}_$seed" "$seed" "$outline" "$force" >"$file.part" && mv "$file.part" "$file"
  done
done <<'OUTLINES'
example_a 0.005
example_c 0.005
shade 0.05
chair_back 0.05
OUTLINES
{
  echo "outline,seed,tiles,largest,uniform,error,ratio,solutions,seconds"
  cat "$out"/rows/*.csv
} >"$out/rows_outlines.csv"
python3 - "$out/rows_outlines.csv" <<'PYTHON' | tee "$out/outlines.md"
import collections, csv, statistics, sys
groups = collections.defaultdict(list)
for row in csv.DictReader(open(sys.argv[1])):
    groups[row["outline"]].append(row)
print("| outline | tiles | runs | largest displacement, mm | best uniform, % | error, % | ratio | worst ratio | solutions | seconds |")
print("|---|---|---|---|---|---|---|---|---|---|")
every = []
for outline, rows in groups.items():
    median = lambda column: statistics.median(float(row[column]) for row in rows)
    ratios = [float(row["ratio"]) for row in rows]
    every += ratios
    print(f"| {outline} | {rows[0]['tiles']} | {len(rows)} | {1000 * median('largest'):.0f} | {100 * median('uniform'):.3g} | "
          f"{100 * median('error'):.3g} | {statistics.median(ratios):.3g} | {max(ratios):.3g} | {median('solutions'):.0f} | {median('seconds'):.1f} |")
print(f"\nOf all {len(every)}: median {statistics.median(every):.3g}, worst {max(every):.3g}.")
PYTHON

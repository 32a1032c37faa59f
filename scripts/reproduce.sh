#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Regenerate what the paper prints, and say how it compares: item | paper | ours | verdict. Each experiment can be run alone.
# Ends with one page of it all: out/reproduce/report.html.
set -uo pipefail
cd "$(dirname "$0")/.."
scripts/build.sh || exit 1

program=build/release/apps/fretwork/fretwork
out=out/reproduce
mkdir -p "$out"
status=0
echo "item | paper | ours | verdict"
echo "---|---|---|---"
for experiment in table1_enumeration calibration_statistics table3_accuracy; do
  "experiments/$experiment/run.sh" "$program" "$out" | tee "$out/$experiment.rows" || status=1
done
experiments/figures/run.sh "$program" out/figures >/dev/null || status=1
experiments/report/report.py "$program" "$out" out/figures "$out/report.html" || status=1
exit $status

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Regenerate what the paper prints, and say how it compares: item | paper | ours | verdict. Each experiment can be run alone.
set -uo pipefail
cd "$(dirname "$0")/.."
scripts/build.sh || exit 1

status=0
echo "item | paper | ours | verdict"
echo "---|---|---|---"
for experiment in table1_enumeration calibration_statistics table3_accuracy; do
  "experiments/$experiment/run.sh" || status=1
done
exit $status

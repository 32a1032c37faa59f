#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Regenerate the tables of README.md and the plot; builds its programs unless a build is given. Usage: run.sh [FOLDER OF THE BUILD] [OUTPUT FOLDER]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
programs=${1:-$here/../../build/release}/experiments/verification
out=${2:-$here/../../out/verification}
mkdir -p "$out"
[[ -n ${1:-} ]] || "$here/../../scripts/build.sh" verification_benchmarks verification_responses verification_staged_frame fretwork
"$programs/verification_benchmarks" "$out/verification.svg" | tee "$out/benchmarks.md"
"$programs/verification_responses" | tee "$out/responses.md"
"$programs/verification_responses" --stable-branch --sample 0 | tee "$out/responses_stable_branch.md"
program=$(realpath "$programs/../../apps/fretwork/fretwork")
python3 "$here/public_solver.py" "$program" "$programs/verification_staged_frame" "$out/public_solver" | tee "$out/public_solver.md"

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Fuzz the readers of strangers' files and messages (tests/fuzz) with libFuzzer, address and undefined sanitizers; a line for each.
# What is found lies in build/fuzz/found, what was learnt in build/fuzz/corpus, where the next run goes on.
# Usage: scripts/fuzz.sh [READER..]     (fretwork_fuzz --list names them; without: all)
# FUZZ_SECONDS: wall time of each reader (default 600). FUZZ_SEED: start of the random numbers (default: another one each time).
# FUZZ_JOBS: how many readers run at once (default: one for each processor).
set -uo pipefail
cd "$(dirname "$0")/.."
export seconds=${FUZZ_SECONDS:-600} seed=${FUZZ_SEED:-0} program=build/fuzz/tests/fuzz/fretwork_fuzz

# fuzz_reader READER: exit code 1 if something was found
fuzz_reader() {
  local reader=$1 log=build/logs/fuzz-$1.log verdict="nothing found" found=0
  mkdir -p "build/fuzz/corpus/$reader"
  if ! "$program" --reader="$reader" -max_total_time="$seconds" -seed="$seed" -timeout=20 -rss_limit_mb=2048 -print_final_stats=1 \
    -artifact_prefix="build/fuzz/found/$reader-" "build/fuzz/corpus/$reader" "tests/fuzz/corpora/$reader" >"$log" 2>&1; then
    verdict=$(grep -hE '^SUMMARY|^broken promise' "$log" | head -n 1)
    verdict="FOUND: ${verdict:-see $log}"
    found=1
  fi
  printf '%-15s %12s runs in %s s: %s\n' "$reader" "$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")" "$seconds" "$verdict"
  return $found
}
export -f fuzz_reader

scripts/show_build.sh fuzz build/logs/fuzz-build.log fretwork_fuzz || exit 1
[[ $# -gt 0 ]] || mapfile -t all < <("$program" --list)
mkdir -p build/fuzz/found build/logs
printf '%s\n' "${@:-${all[@]}}" | xargs -P "${FUZZ_JOBS:-$(nproc)}" -I '{}' bash -c 'fuzz_reader "$1"' fuzz '{}'

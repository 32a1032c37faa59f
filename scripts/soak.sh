#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What a night is long enough for; each part says what it found, and one that fails does not end the others.
# Usage: scripts/soak.sh [PART..]
#   pages    the commands that print the tables of experiments/*/README.md, and whether the tables are what they print
#   storm    an hour of two pages of the studio and the command line on one file (STORM_SECONDS)
#   attack   tests/attack/attack.py
#   fuzz     ten minutes for each reader of strangers' files (FUZZ_SECONDS)
#   calls    random calls of the Python module (FRETWORK_RANDOM_CALLS, 50000 for each of two seeds, from FRETWORK_RANDOM_SEED on)
#   packages the packages, built twice, are the same to the bit
set -uo pipefail
cd "$(dirname "$0")/.."
root=$PWD
mkdir -p build/logs
build=build/release
parts=(pages storm attack fuzz calls packages)

part_pages() {
  local status=0
  python3 -B experiments/common/pages.py "$build" || status=1
  python3 -B experiments/common/pages.py "$build" --slow || status=1
  return $status
}

part_storm() {
  cmake -E copy_directory apps/studio/page/tests "$build/apps/studio/page/tests"
  FRETWORK_STORM_SECONDS=${STORM_SECONDS:-3600} FRETWORK_PROGRAM=$PWD/$build/apps/fretwork/fretwork \
    FRETWORK_PAGE=$PWD/$build/apps/share/fretwork/studio.html FRETWORK_REPOSITORY=$PWD FRETWORK_PICTURES=$PWD/build/logs \
    CHROMIUM=$(command -v chromium || command -v chromium-browser) \
    node "$build/apps/studio/page/tests/browser/run.mjs" storm.test.mjs
}

part_attack() { python3 -B tests/attack/attack.py "$build/apps/fretwork/fretwork" --rounds "${ATTACK_ROUNDS:-2000}"; }

part_fuzz() { scripts/fuzz.sh; }

# The module of `make python`, which lies in the build's folder.
part_calls() {
  scripts/python.sh && (cd tests/python &&
    FRETWORK_RANDOM_CALLS=${FRETWORK_RANDOM_CALLS:-50000} FRETWORK_SOURCE_DIR=$root PYTHONPATH=$root/$build/apps/python /usr/bin/python3 -B -m unittest test_calls)
}

part_packages() { scripts/packages.sh page build && scripts/packages.sh again; }

[[ $# -gt 0 ]] || set -- "${parts[@]}"
for part in "$@"; do
  [[ " ${parts[*]} " == *" $part "* ]] || { echo "soak.sh: unknown part '$part'; there is: ${parts[*]}" >&2; exit 2; }
done
scripts/show_build.sh release build/logs/soak-build.log || exit 1
failed=0
for part in "$@"; do
  started=$SECONDS
  if "part_$part" 2>&1 | tee "build/logs/soak-$part.log"; then verdict=passed; else verdict=FAILED failed=$((failed + 1)); fi
  echo "== $part $verdict after $((SECONDS - started)) s"
done
[[ $failed -eq 0 ]]

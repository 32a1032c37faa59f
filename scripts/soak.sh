#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What a night is long enough for; each part says what it found, and one that fails does not end the others.
# Usage: scripts/soak.sh [PART..]
#   pages    the commands that print the tables of experiments/*/README.md, and whether the tables are what they print
#   storm    an hour of two pages of the studio and the command line on one file (STORM_SECONDS)
#   attack   tests/attack/attack.py
#   fuzz     ten minutes for each reader of strangers' files (FUZZ_SECONDS)
#   packages the packages, built twice, are the same to the bit
set -uo pipefail
cd "$(dirname "$0")/.."
mkdir -p build/logs
build=build/release

part_pages() {
  python3 -B experiments/common/pages.py "$build" && python3 -B experiments/common/pages.py "$build" --slow
}

part_storm() {
  FRETWORK_STORM_SECONDS=${STORM_SECONDS:-3600} FRETWORK_PROGRAM=$PWD/$build/apps/fretwork/fretwork \
    FRETWORK_PAGE=$PWD/$build/apps/share/fretwork/studio.html FRETWORK_REPOSITORY=$PWD FRETWORK_PICTURES=$PWD/build/logs \
    CHROMIUM=$(command -v chromium || command -v chromium-browser) \
    node "$build/apps/studio/page/tests/browser/run.mjs" storm.test.mjs
}

part_attack() { python3 -B tests/attack/attack.py "$build/apps/fretwork/fretwork" --rounds "${ATTACK_ROUNDS:-2000}"; }

part_fuzz() { scripts/fuzz.sh; }

part_packages() { scripts/packages.sh page build && scripts/packages.sh again; }

[[ $# -gt 0 ]] || set -- pages storm attack fuzz packages
scripts/show_build.sh release build/logs/soak-build.log || exit 1
cmake -E copy_directory apps/studio/page/tests "$build/apps/studio/page/tests"
failed=0
for part in "$@"; do
  case "$part" in
    pages | storm | attack | fuzz | packages) ;;
    *) echo "soak.sh: unknown part '$part'; there is: pages, storm, attack, fuzz, packages" >&2; exit 2 ;;
  esac
  started=$SECONDS
  if "part_$part" 2>&1 | tee "build/logs/soak-$part.log"; then verdict=passed; else verdict=FAILED failed=$((failed + 1)); fi
  echo "== $part $verdict after $((SECONDS - started)) s"
done
[[ $failed -eq 0 ]]

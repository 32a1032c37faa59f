#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Line coverage of framework/ by the tests of `make test`: builds everything anew with gcov's counters, runs the tests, and ends with
# the files with the most lines that no test runs, and the share. build/coverage/lines.txt names the lines of each file. Some twenty
# minutes on two cores.
# Usage: scripts/coverage.sh [LEAST SHARE IN PERCENT]     exit code 1: below it, or a test failed
set -euo pipefail
cd "$(dirname "$0")/.."
command -v gcovr >/dev/null || { echo "coverage.sh: gcovr is missing: scripts/install-dependencies.sh check" >&2; exit 2; }
scripts/show_build.sh coverage build/logs/coverage-build.log
find build/coverage -name '*.gcda' -delete
status=0
ctest --preset coverage -j "$(nproc)" >build/logs/coverage-tests.log 2>&1 || status=1
gcovr --root . --filter framework/fretwork --exclude-throw-branches --object-directory build/coverage --sort-uncovered --txt build/coverage/lines.txt \
  --fail-under-line "${1:-0}" >/dev/null || status=1
tail -n 14 build/coverage/lines.txt
exit $status

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Build the command line, optimized, and nothing that it does not need. Prints only what went wrong.
# Usage: scripts/build.sh [TARGET..]     other programs instead, such as those of experiments
set -euo pipefail
cd "$(dirname "$0")/.."
mkdir -p build/logs
log=build/logs/program-build.log
[[ $# -gt 0 ]] || set -- fretwork
{ cmake --preset release && cmake --build --preset release --target "$@"; } >"$log" 2>&1 || {
  tail -n 60 "$log" >&2
  echo "build.sh: the build failed; all of it is in $log" >&2
  exit 1
}

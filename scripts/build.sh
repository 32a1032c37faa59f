#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Build the command line, optimized, and nothing that it does not need. Prints only what went wrong.
set -euo pipefail
cd "$(dirname "$0")/.."
mkdir -p build/logs
log=build/logs/program-build.log
{ cmake --preset release && cmake --build --preset release --target fretwork; } >"$log" 2>&1 || {
  tail -n 60 "$log" >&2
  echo "build.sh: the build failed; all of it is in $log" >&2
  exit 1
}

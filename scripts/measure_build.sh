#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Build a target from nothing and print the processor time of its compilations, stage by stage.
# Usage: scripts/measure_build.sh [TARGET [CMAKE OPTION..]]     default: fretwork, as the preset release builds it
set -euo pipefail
cd "$(dirname "$0")/.."
target=${1:-fretwork}
shift || true
folder=build/measured
rm -rf "$folder"
export FRETWORK_BUILD_TIMES="$PWD/$folder/times"
cmake --preset release -B "$folder" -DCMAKE_CXX_COMPILER_LAUNCHER="$PWD/scripts/timed_compiler.sh" "$@" >/dev/null
cmake --build "$folder" --target "$target" >"$folder/build.log"
scripts/sum_build_times.sh "$FRETWORK_BUILD_TIMES"

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Build the program with the studio's page, and open it on the demo's project (or on its start screen).
# Usage: scripts/studio.sh [OPTIONS OF fretwork studio]
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/build.sh
log=build/logs/studio-page.log
cmake --build --preset release --target fretwork_studio_page >"$log" 2>&1 || { tail -n 40 "$log" >&2; exit 1; }
page=build/release/apps/share/fretwork/studio.html
[[ -f $page ]] || { tail -n 20 "$log" >&2; echo "studio.sh: the page could not be built; all of it is in $log" >&2; exit 1; }
project=()
[[ -f out/project.json ]] && project=(out/project.json)
exec build/release/apps/fretwork/fretwork studio "${project[@]}" "$@"

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Build the command line, optimized, and nothing that it does not need. On a terminal it shows its progress.
# Usage: scripts/build.sh [TARGET..]     other programs instead, such as those of experiments
set -euo pipefail
cd "$(dirname "$0")/.."
[[ $# -gt 0 ]] || set -- fretwork
exec scripts/show_build.sh release build/logs/program-build.log "$@"

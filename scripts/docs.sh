#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Build the program if it is not there yet, and the site from the repository's pages: build/site/index.html. Usage: scripts/docs.sh
set -euo pipefail
cd "$(dirname "$0")/.."
python=/usr/bin/python3 # Debian's, for which Sphinx is installed; another one may come first in PATH
[[ -x $python ]] || python=python3
[[ -x build/release/apps/fretwork/fretwork ]] || scripts/build.sh
exec "$python" -B scripts/site/build.py "$@"

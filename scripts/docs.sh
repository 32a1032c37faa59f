#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Bring the program up to date, and build the site from the repository's pages: build/site/index.html. Usage: scripts/docs.sh
set -euo pipefail
cd "$(dirname "$0")/.."
python=/usr/bin/python3 # Debian's, for which Sphinx is installed; another one may come first in PATH
[[ -x $python ]] || python=python3
scripts/build.sh
exec "$python" -B scripts/site/build.py "$@"

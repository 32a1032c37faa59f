#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Build the Python package as a wheel in out/, and say how to install it.
# Usage: scripts/python.sh
set -euo pipefail
cd "$(dirname "$0")/.."
python=/usr/bin/python3 # Debian's, whose headers and numpy are there; another one may come first in PATH
[[ -x $python ]] || python=python3
mkdir -p build/logs
scripts/show_build.sh release build/logs/python-configure.log fretwork_exports fretwork_typed
if ! "$python" -B apps/python/build_backend.py out >build/logs/python-build.log 2>&1; then
  tail -n 60 build/logs/python-build.log >&2
  exit 1
fi
tail -n 1 build/logs/python-build.log
wheel=$(ls -t out/fretwork-*.whl | head -n 1)
echo "Install it into an environment of your own:"
echo "  $python -m venv --system-site-packages own && own/bin/pip install --no-index $wheel"
echo "or try it where it is: PYTHONPATH=build/release/apps/python $python -c 'import fretwork; print(fretwork.__version__)'"

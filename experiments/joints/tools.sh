#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Exit code 77, and what is missing, unless gmsh, CalculiX, NumPy and SciPy are there. Usage: tools.sh PYTHON
set -euo pipefail
command -v ccx >/dev/null || { echo "CalculiX is missing: apt-get install calculix-ccx"; exit 77; }
"$1" -c 'import gmsh' 2>/dev/null || { echo "$1 lacks gmsh: apt-get install gmsh python3-gmsh, or set PYTHON"; exit 77; }
"$1" -c 'import numpy, scipy' 2>/dev/null || { echo "$1 lacks NumPy or SciPy: apt-get install python3-numpy python3-scipy"; exit 77; }

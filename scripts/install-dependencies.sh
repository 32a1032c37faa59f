#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Install what is missing on Debian 12, and nothing else. Works as root and with sudo; says nothing when all is there.
# Usage: scripts/install-dependencies.sh [demo|test|check|studio|python|docs|packages]   (test holds demo; check holds test, python, docs and packages;
# studio, python, docs and packages hold demo; studio, packages and check: Node.js with npm, unless there is one that fits; default: test)
set -euo pipefail

demo=(g++ cmake ninja-build git ca-certificates
      libcgal-dev libceres-dev libnlopt-dev libpagmo-dev libeigen3-dev libboost-dev libboost-graph-dev libboost-serialization-dev libtbb-dev libopenmesh-dev libsuitesparse-dev
      libopenblas0-serial libnauty2-dev libsqlite3-dev nettle-dev nlohmann-json3-dev libcli11-dev libpugixml-dev libmuparser-dev libpng-dev libfreetype-dev libpolyclipping-dev libzip-dev
      librsvg2-bin fonts-dejavu-core)
test=("${demo[@]}" libgtest-dev libgmock-dev libbenchmark-dev clang-format gringo groff-base python3-jsonschema sqlite3)
python=("${demo[@]}" pybind11-dev python3-dev python3-numpy python3-pip python3-venv)
docs=("${demo[@]}" doxygen furo libjs-katex node-normalize.css python3-myst-parser python3-sphinx python3-sphinx-copybutton)
packages=("${python[@]}" "${docs[@]}" debhelper dh-python dpkg-dev lintian mmdebstrap reuse)
check=("${test[@]}" "${packages[@]}" libocct-data-exchange-dev codespell mypy python3-pandas python3-torch clang-16 clang-tidy-16 gcovr libclang-rt-16-dev calculix-ccx gmsh python3-gmsh slurm-wlm munge snakemake python3-numpy python3-scipy python3-cvxopt python3-matplotlib python3-ezdxf python3-vtk9 admesh prusa-slicer inkscape chromium)

# A Node.js of 18.18 or newer, wherever it comes from, and npm.
has_fitting_node() {
  command -v npm >/dev/null && command -v node >/dev/null &&
    node -e 'const [a, b] = process.versions.node.split(".").map(Number); process.exit(a > 18 || (a === 18 && b >= 18) ? 0 : 1)'
}

case "${1:-test}" in
  demo) wanted=("${demo[@]}") ;;
  test) wanted=("${test[@]}") ;;
  check) wanted=("${check[@]}"); has_fitting_node || wanted+=(nodejs npm) ;;
  python) wanted=("${python[@]}") ;;
  docs) wanted=("${docs[@]}") ;;
  packages) wanted=("${packages[@]}"); has_fitting_node || wanted+=(nodejs npm) ;;
  studio) wanted=("${demo[@]}"); has_fitting_node || wanted+=(nodejs npm) ;;
  *) echo "install-dependencies.sh: unknown set '$1'; there is: demo, test, check, studio, python, docs, packages" >&2; exit 2 ;;
esac

if ! command -v apt-get >/dev/null; then
  echo "install-dependencies.sh: this system has no apt-get; install these Debian packages' like by hand: ${wanted[*]}" >&2
  exit 2
fi

missing=()
for package in "${wanted[@]}"; do
  status=$(dpkg-query --show --showformat='${db:Status-Abbrev}' "$package" 2>/dev/null || true)
  [[ $status == ii* ]] || missing+=("$package")
done
[[ ${#missing[@]} -eq 0 ]] && exit 0

as_root=()
if [[ $(id -u) -ne 0 ]]; then
  command -v sudo >/dev/null || { echo "install-dependencies.sh: run as root, or install sudo; missing: ${missing[*]}" >&2; exit 2; }
  as_root=(sudo)
fi
echo "Installing: ${missing[*]}"
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null

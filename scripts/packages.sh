#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Build the Debian packages of the tracked files in out/packages, hold them against lintian, and try them in an empty Debian root.
# Usage: scripts/packages.sh [STEP..]     steps: page build lint try (all of them, in this order), and again: build a second time
#                                         in another folder without a compiler cache, and compare every package bit by bit
# PACKAGE_JOBS: how many compilers run at once (default: one for each processor).
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
work=$root/build/packages
packages=$root/out/packages
logs=$root/build/logs
jobs=${PACKAGE_JOBS:-$(nproc)}
mkdir -p "$work" "$packages" "$logs"

# The studio's page needs npm and its registry, so it is built in the tree, and packaged as it is.
step_page() {
  scripts/show_build.sh release "$logs/studio-page.log" fretwork_studio_page
  cp build/release/apps/share/fretwork/studio.html "$work/studio.html"
}

# stage FOLDER: the tracked files as they are, and the page.
stage() {
  rm -rf "$1"
  mkdir -p "$1/debian/prebuilt"
  git ls-files -z | tar --create --null --files-from=- | tar --extract --directory "$1"
  cp "$work/studio.html" "$1/debian/prebuilt/"
}

# build_in FOLDER LOG: packages beside the folder. Flags come from dpkg alone.
build_in() {
  (cd "$1" && env -u CFLAGS -u CXXFLAGS -u LDFLAGS FRETWORK_COMMIT="$(git -C "$root" describe --always --dirty --abbrev=12)" \
    dpkg-buildpackage --build=binary --no-sign --jobs="$jobs") >"$2" 2>&1 ||
    { tail -n 60 "$2" >&2; echo "packages.sh: the packages could not be built; all of it is in $2" >&2; exit 1; }
}

step_build() {
  stage "$work/one/fretwork"
  rm -f "$work"/one/*.*
  build_in "$work/one/fretwork" "$logs/packages.log"
  rm -f "$packages"/*
  cp "$work"/one/*.deb "$work"/one/*.changes "$packages"
  (cd "$packages" && sha256sum ./*.deb >SHA256SUMS)
  ls -sh "$packages"/*.deb
}

step_lint() {
  lintian --fail-on error,warning --tag-display-limit 0 "$work"/one/*.changes
  echo "lintian: no errors, no warnings"
}

step_try() { scripts/try_packages.sh "$packages"; }

# Another path, another umask and no cache: what depends on them shows.
step_again() {
  local folder=$work/second_place/of_another_name/fretwork
  umask 027
  stage "$folder"
  rm -f "$folder"/../*.*
  CMAKE_CXX_COMPILER_LAUNCHER='' CMAKE_C_COMPILER_LAUNCHER='' CCACHE_DISABLE=1 build_in "$folder" "$logs/packages-again.log"
  (cd "$folder/.." && sha256sum --check "$packages/SHA256SUMS")
  echo "both builds are identical"
}

[[ $# -gt 0 ]] || set -- page build lint try
for step in "$@"; do
  case "$step" in
    page | build | lint | try | again) "step_$step" ;;
    *) echo "packages.sh: unknown step '$step'; there is: page, build, lint, try, again" >&2; exit 2 ;;
  esac
done

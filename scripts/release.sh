#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Check what a release needs, and make its files in out/release. Nothing is tagged or published: docs/release.md says what is left.
# Usage: scripts/release.sh VERSION
set -euo pipefail
cd "$(dirname "$0")/.."
version=${1:?Usage: scripts/release.sh VERSION}
out=out/release

refuse() { echo "release.sh: $1" >&2; exit 1; }

[[ -z $(git status --porcelain) ]] || refuse "there are changes that are not committed: commit them first"
[[ $(git branch --show-current) == main ]] || refuse "this is not the branch main"
grep -q "project(fretwork VERSION $version " CMakeLists.txt || refuse "CMakeLists.txt names another version than $version"
grep -qx "version: $version" CITATION.cff || refuse "CITATION.cff names another version than $version"
head -n 1 debian/changelog | grep -q "($version)" || refuse "debian/changelog begins with another version than $version"
grep -q "^## \[$version\]" CHANGELOG.md || refuse "CHANGELOG.md has no section for $version"
for page in README.md docs/start/install.md; do
  grep -q "fretwork_${version}_amd64.deb" "$page" || refuse "$page names packages of another version than $version"
done
soname=${version%%.*} # from 1.0 on; before it MAJOR.MINOR: docs/reference/versions.md
[[ $soname -gt 0 ]] || soname=${version%.*}
grep -qx "Package: libfretwork$soname" debian/control || refuse "debian/control names the library's package for another version than $version"
[[ -e debian/libfretwork$soname.install ]] || refuse "debian/libfretwork$soname.install is missing"

scripts/install-dependencies.sh check
reuse lint --quiet || refuse "there are files whose licence is not known: reuse lint names them"
make test
make check
make docs
make packages
scripts/packages.sh again
make python

rm -rf "$out"
mkdir -p "$out"
git archive --format=tar.gz --prefix="fretwork-$version/" --output="$out/fretwork-$version.tar.gz" HEAD
reuse spdx --output "$out/fretwork-$version.spdx" 2>/dev/null
cp out/packages/*.deb out/fretwork-"$version"-*.whl "$out"
(cd "$out" && sha256sum -- * >SHA256SUMS)
ls -sh "$out"
echo "all is there; what is left is in docs/release.md"

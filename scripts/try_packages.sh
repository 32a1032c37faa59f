#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Install the packages in an empty Debian root, and use each as its users would: the tour, a C++ consumer, Python, the studio.
# Usage: scripts/try_packages.sh FOLDER     FOLDER: where the .deb files lie. Needs root and mmdebstrap; the root is removed at the end.
set -euo pipefail
cd "$(dirname "$0")/.."
packages=$(realpath "$1")
root=$(mktemp -d)

clean() {
  umount "$root/proc" "$root/dev" 2>/dev/null || true
  rm -rf --one-file-system "$root"
}
trap clean EXIT

inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }

step() { echo "== $1"; }

step "an empty Debian 12"
mmdebstrap --quiet --variant=apt --include=ca-certificates bookworm "$root"
mount -t proc proc "$root/proc"
mount --bind /dev "$root/dev"
cp -L /etc/resolv.conf "$root/etc/resolv.conf"
mkdir "$root/packages"
cp "$packages"/*.deb "$root/packages"
inside apt-get update -qq

step "the program is installed"
inside bash -c 'apt-get install -qq -y --no-install-recommends --download-only /packages/fretwork_*.deb >/packages/install.log 2>&1' || { tail "$root/packages/install.log" >&2; exit 1; }
started=$SECONDS # without the network's share
inside bash -c 'apt-get install -qq -y --no-install-recommends /packages/fretwork_*.deb >/packages/install.log 2>&1' || { tail "$root/packages/install.log" >&2; exit 1; }
echo "in $((SECONDS - started)) s, $(inside fretwork --version | head -n 1)"
[[ $((SECONDS - started)) -le 60 ]] || { echo "try_packages.sh: the installation took more than a minute" >&2; exit 1; }

step "a surface, from the examples of the package"
inside bash -euo pipefail -c '
  cd /root
  examples=/usr/share/doc/fretwork/examples
  fretwork enumerate --layout paper7 --list patterns.txt >/dev/null
  fretwork tile $examples/outlines/example_a.svg --patterns 0-1+1-6 --out project.json
  fretwork case add project.json $examples/cases/cantilever.json
  fretwork simulate project.json --case cantilever --model full --out full.json
  fretwork simulate project.json --case cantilever --model corotational --out reduced.json
  fretwork compare full.json reduced.json
  fretwork export project.json --result full.json --to picture.png --to page.html
  fretwork check project.json full.json picture.png
  man_page=/usr/share/man/man1/fretwork.1.gz; test -s $man_page'

step "the studio answers"
inside bash -euo pipefail -c '
  cd /root
  fretwork studio project.json --no-browser --port 8931 >studio.log 2>&1 &
  studio=$!
  for _ in $(seq 100); do grep -q "http://" studio.log && break; sleep 0.1; done
  address=$(grep -o "http://[^ ]*" studio.log | head -n 1)
  exec 3<>/dev/tcp/127.0.0.1/8931
  printf "GET /%s HTTP/1.0\r\nHost: 127.0.0.1:8931\r\n\r\n" "${address#http://*/}" >&3
  grep -q "<title>" <&3
  kill $studio
  echo "its page comes"'

step "Python"
inside bash -c 'apt-get install -qq -y --no-install-recommends /packages/python3-fretwork_*.deb >/packages/install.log 2>&1' || { tail "$root/packages/install.log" >&2; exit 1; }
inside python3 -c 'import fretwork as fw; print(len(fw.enumerate_patterns(fw.paper_layout())), "patterns")'

step "a C++ program by find_package"
inside bash -c 'apt-get install -qq -y --no-install-recommends g++ cmake make /packages/libfretwork*.deb >/packages/install.log 2>&1' || { tail "$root/packages/install.log" >&2; exit 1; }
cp -r tests/install "$root/root/consumer"
inside bash -euo pipefail -c 'cd /root/consumer && cmake -B build -DCMAKE_BUILD_TYPE=Release >/dev/null && cmake --build build >/dev/null && build/consumer'

step "the documentation"
inside bash -c 'apt-get install -qq -y --no-install-recommends /packages/fretwork-doc_*.deb >/packages/install.log 2>&1' || { tail "$root/packages/install.log" >&2; exit 1; }
inside test -s /usr/share/doc/fretwork-doc/html/index.html
echo "all packages work"

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Make the pictures of the site (docs/pictures/) again, from the program alone. Half a minute; the studio's pictures need Chromium.
# Usage: scripts/site/pictures.sh [PROGRAM] [OUTPUT FOLDER]
set -euo pipefail
here=$(cd "$(dirname "$0")/../.." && pwd)
fretwork=$(realpath "${1:-$here/build/release/apps/fretwork/fretwork}")
out=$(realpath -m "${2:-$here/docs/pictures}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$out"
cd "$work"

"$fretwork" enumerate --sample 17 --seed 4 --svg "$out/patterns.svg" >/dev/null
"$fretwork" enumerate --edges 2..3 --svg "$out/rejected.svg" --reasons >/dev/null
"$fretwork" enumerate --library library.db >/dev/null
"$fretwork" calibrate --library library.db --patterns sample:24 >/dev/null
"$fretwork" library export --library library.db --svg "$out/reduced.svg" --patterns sample:4 >/dev/null
"$fretwork" library show 0-1+3-6 --library library.db --scenarios "$out/scenarios.svg" >/dev/null

# The first hour: the specimen, bent by its own weight.
"$fretwork" tile "$here/experiments/outlines/specimen.svg" --patterns random:1 --library library.db --out specimen.json >/dev/null 2>&1
"$fretwork" case add specimen.json "$here/experiments/cases/own_weight.json" >/dev/null
"$fretwork" simulate specimen.json --model full --out full.json >/dev/null
"$fretwork" export specimen.json --case own-weight --to "$out/tiles.svg"
"$fretwork" export specimen.json --case own-weight --result full.json --size 1000x625 --to "$out/bent.png"
"$fretwork" export specimen.json --case own-weight --result full.json --colour von_mises --size 1000x625 --to "$out/stress.png"
"$fretwork" design specimen.json --case own-weight --target "$here/experiments/targets/bow.json" --palette library --out bow.json >/dev/null
"$fretwork" simulate bow.json --model full --out bow_full.json >/dev/null
"$fretwork" export bow.json --case own-weight --result bow_full.json --size 1000x625 --to "$out/bow.png"

palette=0-1+1-6,0-5+5-6,2-4+2-6+4-6
# Example A: painted from soft to stiff, as a bridge.
"$fretwork" calibrate --library library.db --patterns "$palette" >/dev/null
"$fretwork" tile "$here/experiments/outlines/example_a.svg" --patterns field:u --palette "$palette" --property bending_stiffness --dither \
  --library library.db --out graded.json >/dev/null 2>&1
"$fretwork" case add graded.json "$here/experiments/cases/bridge.json" >/dev/null
"$fretwork" simulate graded.json --case bridge --model full --out graded_full.json >/dev/null
"$fretwork" export graded.json --to "$out/graded.svg"
"$fretwork" export graded.json --case bridge --result graded_full.json --size 1000x625 --to "$out/graded_bent.png"
"$fretwork" export graded.json --to "$out/cut.svg" --content cut --frame 4mm --fillet 0.5mm

# picture_of NAME SIZE WORDS..: the studio that is started with these words, as a browser without a graphics card shows it.
picture_of() {
  local name=$1 size=$2
  shift 2
  local log=$name.log  # its own: in the log of the studio before it, the old address could be read
  "$fretwork" studio --no-browser --port 8741 "$@" >"$log" 2>&1 &
  studio=$!
  trap 'kill $studio 2>/dev/null; rm -rf "$work"' EXIT
  for _ in $(seq 50); do grep -qs http "$log" && break; sleep 0.1; done
  address=$(grep -o 'http://[^ ]*' "$log" | head -n 1)
  chromium --headless --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader --hide-scrollbars --window-size="$size" \
    --user-data-dir="$work/browser" --timeout=20000 --virtual-time-budget=20000 --screenshot="$out/$name.png" "$address" 2>/dev/null
  kill $studio
  wait $studio || true
}
if command -v chromium >/dev/null; then
  picture_of studio 1440,900 graded.json
  picture_of layout 1280,800 --layout paper8
fi
ls "$out"

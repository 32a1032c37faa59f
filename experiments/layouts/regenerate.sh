#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Make the census and the picture of every layout of this folder again.
# Usage: experiments/layouts/regenerate.sh path/to/fretwork
set -euo pipefail
fretwork=$(realpath "${1:?the fretwork program}")
cd "$(dirname "$0")"
for layout in *.json; do
  name=${layout%.json}
  "$fretwork" enumerate --layout "$layout" --census "$name.csv" >/dev/null
  choice=()
  [[ $("$fretwork" enumerate --layout "$layout" --count) -gt 31 ]] && choice=(--sample 31 --seed 1)
  "$fretwork" enumerate --layout "$layout" "${choice[@]}" --svg "$name.svg" >/dev/null
done

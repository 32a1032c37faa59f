#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The main job: from the paper's node layout to a simulated, drawn surface. Results go to out/. Usage: scripts/demo.sh
set -euo pipefail
cd "$(dirname "$0")/.."

say() { printf '\n\033[1m%s\033[0m\n' "$*"; }
[[ -t 1 ]] || say() { printf '\n%s\n' "$*"; }

# The table of README.md from rows of Table 3, by the names of their columns.
show_comparison() {
  awk -F, '
    NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i
              printf "%-12s %16s %12s %15s\n", "", "largest error", "mean error", "rotation error"; next }
            { printf "%-14s %11.3f mm %9.3f mm %10.4f rad\n", $1, 1e3 * $at["max_translation_error_m"], 1e3 * $at["mean_translation_error_m"], $at["max_rotation_error_rad"] }'
}

say "Building (the first time takes some minutes)"
scripts/build.sh

program=build/release/apps/fretwork/fretwork
outline=experiments/outlines/example_a.svg
out=out
mkdir -p "$out"
# Only what this script makes: other results in the folder stay.
rm -f "$out"/{library.db,table1.csv,project.json,comparison.csv,view.html,picture.png,full.vtu} \
  "$out"/{full,paper6,condensed,corotational,mixed-0.05}.json "$out"/{surface,deformed,displacement}.{svg,png}
started=$SECONDS

say "1. Enumerate the patterns of the paper's layout (its Table 1)"
"$program" enumerate --layout paper7 --census "$out/table1.csv" --library "$out/library.db"

say "2. Calibrate the reduced model of 24 patterns across edge counts"
"$program" calibrate --library "$out/library.db" --patterns sample:24

say "3. Tile the outline $outline and paint it with the calibrated patterns"
"$program" tile "$outline" --patterns random:1 --library "$out/library.db" --out "$out/project.json"
"$program" case add "$out/project.json" experiments/cases/bridge.json

say "4. Simulate it: every beam, nonlinear; then the reduced models, of which the first two are linear"
reduced=(paper6 condensed corotational mixed:0.05)
for model in full "${reduced[@]}"; do
  "$program" simulate "$out/project.json" --model "$model" --out "$out/${model/:/-}.json"
done

say "5. Compare the reduced models with the full one (the columns of the paper's Table 3)"
"$program" compare "$out/full.json" "$out/paper6.json" --name paper6 --csv >"$out/comparison.csv"
for model in "${reduced[@]:1}"; do
  "$program" compare "$out/full.json" "$out/${model/:/-}.json" --name "$model" --csv | tail -n 1 >>"$out/comparison.csv"
done
show_comparison <"$out/comparison.csv"

say "6. Draw it"
"$program" export "$out/project.json" --case bridge --to "$out/surface.svg"
"$program" export "$out/project.json" --result "$out/full.json" --result "$out/paper6.json" --to "$out/deformed.svg"
"$program" export "$out/project.json" --result "$out/full.json" --to "$out/displacement.svg" --to "$out/full.vtu"
"$program" export "$out/project.json" --result "$out/full.json" --case bridge --to "$out/view.html" --to "$out/picture.png"
for picture in surface deformed displacement; do
  rsvg-convert --width 1600 --output "$out/$picture.png" "$out/$picture.svg"
done

say "Done in $((SECONDS - started)) s. Look at:"
cat <<END
  $out/picture.png       the bent surface, on transparent ground
  $out/view.html         the same in 3D, for any browser: to turn, to zoom, to give to others
  $out/surface.png       the tessellation with its supports and loads      (also .svg)
  $out/deformed.png      full model (grey) and the paper's reduced model (blue)  (also .svg)
  $out/displacement.png  how far every beam moves                          (also .svg)
  $out/full.vtu          the full model's displacements, for ParaView
  $out/project.json      the project: outline, tessellation, painting, load case
  $out/library.db        patterns, responses and calibrations (SQLite)
  $out/table1.csv, $out/comparison.csv
END

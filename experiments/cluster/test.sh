#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Shards under Slurm, cancelled once in between, give the library of an undisturbed run on one machine; so does
# Snakemake. Usage: test.sh PROGRAM slurm|snakemake        Exit code 77: the engine cannot be started here.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "$1") engine=$2
work=$(mktemp -d /tmp/fretwork_cluster.XXXXXX)
trap 'rm -rf "$work"' EXIT
layout=hollow6
choice=(--patterns sample:18 --starts 1)

# The content of a library without times and hosts.
content() { "$program" library list --library "$1" --json | grep -o '"content_hash": "[0-9a-f]*"'; }

with_slurm() {
  export FRETWORK=$program LAYOUT=$layout work
  # shellcheck disable=SC2016
  "$here/with_slurm.sh" bash -c '
    set -e
    submit=$1; shift
    "$submit" "$work/engine" 3 "$@"
    until [[ -e $work/engine/shard_1.db ]]; do sleep 0.05; done
    scancel --name=fretwork-shards
    while [[ -n $(squeue --noheader) ]]; do sleep 0.2; done
    "$submit" --wait "$work/engine" 3 "$@"' - "$here/submit.sh" "${choice[@]}"
}
with_snakemake() {
  command -v snakemake >/dev/null || { echo "test.sh: no snakemake here (Debian: snakemake)" >&2; exit 77; }
  snakemake --quiet --directory "$work" --snakefile "$here/Snakefile" --cores 2 \
    --config "fretwork=$program" "folder=$work/engine" "layout=$layout" shards=3 "options=${choice[*]}"
}

"with_$engine" || { status=$?; cat "$work"/engine/*.log 2>/dev/null; exit "$status"; }
"$program" enumerate --layout "$layout" --library "$work/alone.db" >/dev/null
"$program" calibrate --library "$work/alone.db" "${choice[@]}" >/dev/null
[[ $(content "$work/engine/library.db") == "$(content "$work/alone.db")" ]] ||
  { echo "test.sh: the merged shards differ from the undisturbed run"; exit 1; }
echo "the merged shards are the undisturbed run"

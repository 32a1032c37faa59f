#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Calibrate a library under Slurm: a job array of N shards, and a job that merges them when all have ended
# well. Run it again to go on after a failure or a cancellation: nothing that is stored is computed twice.
# Usage: [FRETWORK=PROGRAM] [LAYOUT=paper7] [CPUS=1] submit.sh [--wait] FOLDER N [OPTIONS OF fretwork calibrate..]
# The folder has to be one that all nodes see. The result is FOLDER/library.db.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "${FRETWORK:-$here/../../build/release/apps/fretwork/fretwork}")
wait=()
[[ ${1:-} == --wait ]] && { wait=(--wait); shift; }
[[ $# -ge 2 && $2 =~ ^[1-9][0-9]*$ ]] || { sed -n '5,6s/^# //p' "$0" >&2; exit 2; }
mkdir -p "$1"
folder=$(realpath "$1") count=$2
shift 2

# A shard's setting is that of its patterns.db, or what --setting says; its patterns are fixed here.
[[ -e $folder/patterns.db ]] || {
  "$program" enumerate --layout "${LAYOUT:-paper7}" --library "$folder/patterns.part.db" >/dev/null
  mv "$folder/patterns.part.db" "$folder/patterns.db"
}
array=$(sbatch --parsable --job-name=fretwork-shards --array="1-$count" --cpus-per-task="${CPUS:-1}" \
  --output="$folder/shard_%a.log" "$here/shard.sh" "$program" "$folder" array "$@")
echo "shards: job $array"
sbatch --job-name=fretwork-merge --dependency="afterok:$array" --kill-on-invalid-dep=yes "${wait[@]}" \
  --output="$folder/merge.log" "$here/merge.sh" "$program" "$folder" "$count"

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Calibrate the I-th of N parts of a folder's patterns.db into its shard_I.db; goes on where it was stopped.
# Usage: shard.sh PROGRAM FOLDER I/N [OPTIONS OF fretwork calibrate..]
# As a task of a Slurm job array, I/N may be left as "array".
set -euo pipefail
program=$1 folder=$2 part=$3
shift 3
[[ $part == array ]] && part=$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_MAX
shard=$folder/shard_${part%/*}.db

if [[ ! -e $shard ]]; then
  # Copied and renamed: a file of this name is whole.
  cp "$folder/patterns.db" "$shard.part"
  mv "$shard.part" "$shard"
fi
# A pattern that fails is recorded in the shard, and makes this end with 1: the rest is still worth merging.
status=0
"$program" calibrate --library "$shard" --shard "$part" --threads "${SLURM_CPUS_PER_TASK:-1}" "$@" || status=$?
[[ $status -le 1 ]] || exit "$status"

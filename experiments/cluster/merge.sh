#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Merge a folder's shard_1.db .. shard_N.db into its library.db.
# Usage: merge.sh PROGRAM FOLDER N
set -euo pipefail
program=$1 folder=$2 count=$3
shards=()
for i in $(seq "$count"); do shards+=("$folder/shard_$i.db"); done
rm -f "$folder/library.part.db"
"$program" library merge "$folder/library.part.db" "${shards[@]}"
mv "$folder/library.part.db" "$folder/library.db"

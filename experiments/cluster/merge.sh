#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Merge a folder's shard_1.db .. shard_N.db into its library.db.
# Usage: merge.sh PROGRAM FOLDER N
set -euo pipefail
program=$1 folder=$2 count=$3
shards=()
for i in $(seq "$count"); do shards+=("$folder/shard_$i.db"); done
rm -f "$folder/library.db.part"
"$program" library merge "$folder/library.db.part" "${shards[@]}"
mv "$folder/library.db.part" "$folder/library.db"

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Sum what timed_compiler.sh wrote, by the folder of what was compiled.
# Usage: scripts/sum_build_times.sh FILE
awk '{
       name = $3
       sub(/\/CMakeFiles.*/, "", name)
       sub(/^framework\/fretwork\//, "", name)
       if (name == $3 || name == "") name = "precompiled headers"
       seconds[name] += $1 + $2; count[name]++; all += $1 + $2; files++
     }
     END {
       for (name in seconds) printf "%8.1f s  %4d  %s\n", seconds[name], count[name], name | "sort -rn"
       close("sort -rn")
       printf "%8.1f s  %4d  in all\n", all, files
     }' "$1"

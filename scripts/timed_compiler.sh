#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A compiler launcher: run the command, and add its processor time and its output's name to the file $FRETWORK_BUILD_TIMES.
# scripts/measure_build.sh uses it.
output=
for ((i = 1; i < $#; i++)); do [[ ${!i} == -o ]] && { next=$((i + 1)); output=${!next}; }; done
TIMEFORMAT='%U %S'
exec 3>&2
seconds=$({ time "$@" 1>&2 2>&3; } 2>&1)
status=$?
printf '%s %s\n' "$seconds" "$output" >>"$FRETWORK_BUILD_TIMES"
exit $status

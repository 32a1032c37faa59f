#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Configure a preset and build it. On a terminal: one line with the share that is done and the time that is left.
# Otherwise: nothing, but the end of the log where the build fails.
# Usage: scripts/show_build.sh PRESET LOG [TARGET..]
set -uo pipefail
cd "$(dirname "$0")/.."
preset=$1
log=$2
shift 2
targets=()
[[ $# -eq 0 ]] || targets=(--target "$@")
mkdir -p "$(dirname "$log")"

# Reads "[7/60] Building .." and rewrites one line of the terminal.
show_progress() {
  local line started=$SECONDS
  while IFS= read -r line; do
    printf '%s\n' "$line"
    [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]] || continue
    local ready=${BASH_REMATCH[1]} all=${BASH_REMATCH[2]} elapsed=$((SECONDS - started))
    local left=$((elapsed * (all - ready) / ready))
    printf '\r\033[Kbuilding %s: %d %% (%d of %d), %d:%02d so far, about %d:%02d left' "$preset" $((100 * ready / all)) "$ready" "$all" \
      $((elapsed / 60)) $((elapsed % 60)) $((left / 60)) $((left % 60)) >/dev/tty
  done
  printf '\r\033[K' >/dev/tty
}

build() { cmake --preset "$preset" && cmake --build --preset "$preset" "${targets[@]}"; }

if [[ -t 1 ]]; then
  build 2>&1 | show_progress >"$log"
else
  build >"$log" 2>&1
fi
result=$?
if [[ $result -ne 0 ]]; then
  tail -n 60 "$log" >&2
  echo "the build of $preset failed; all that it printed is in $log" >&2
fi
exit $result

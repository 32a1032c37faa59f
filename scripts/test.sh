#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Run the parts of the test suite one after the other, say how long each took, and end with "N passed, N failed".
# Usage: scripts/test.sh PART..       parts: release format check headers sanitizers threads tidy fuzz
set -uo pipefail
cd "$(dirname "$0")/.."

passed=0
failed=0
skipped=0
logs=build/logs
mkdir -p "$logs"

# count_ctest LOG: add the totals that CTest printed; a log without them is one failure. CTest counts a skipped test as passed.
count_ctest() {
  local line left_out
  left_out=$(grep -c '\*\*\*Skipped' "$1")
  line=$(grep -E '[0-9]+% tests passed, [0-9]+ tests failed out of [0-9]+' "$1" | tail -1)
  if [[ $line =~ ([0-9]+)\ tests\ failed\ out\ of\ ([0-9]+) ]]; then
    failed=$((failed + BASH_REMATCH[1]))
    passed=$((passed + BASH_REMATCH[2] - BASH_REMATCH[1] - left_out))
    skipped=$((skipped + left_out))
  else
    failed=$((failed + 1))
  fi
}

# count_once NAME COMMAND..: one command is one test.
count_once() {
  local name=$1
  shift
  if "$@" >"$logs/$name.log" 2>&1; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    tail -n 60 "$logs/$name.log"
    echo "failed: $name"
  fi
}

# build_and_ctest PRESET: configure, build, run every test of that build.
build_and_ctest() {
  local preset=$1
  if ! scripts/show_build.sh "$preset" "$logs/$preset-build.log"; then
    failed=$((failed + 1))
    return
  fi
  local jobs
  jobs=$(nproc)
  if [[ $preset == check ]]; then jobs=$((jobs + 1)); fi  # the storm of the studio's page mostly waits
  ctest --preset "$preset" -j "$jobs" >"$logs/$preset-tests.log" 2>&1 || grep -E '\(Failed\)|\*\*\*|FAILED|Failure' -A 12 "$logs/$preset-tests.log" | head -n 200
  grep -E 'Skipped\)|Not Run' "$logs/$preset-tests.log" || true
  count_ctest "$logs/$preset-tests.log"
}

sources() { git ls-files '*.cpp' '*.hpp'; }

check_format() { sources | xargs clang-format --dry-run --Werror; }

# Every public header compiles by itself. The preset check compiles several sources as one, which would hide what misses.
check_headers() { cmake --preset check >/dev/null && cmake --build --preset check --target all_verify_interface_header_sets; }

# The analyzer is left out of tests. The variable of a benchmark's loop is never read: so the library wants it.
check_tidy() {
  local build=build/tidy
  cmake --preset release -B "$build" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DFRETWORK_BUILD_BENCH=ON \
    -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null &&
    scripts/merge_sources.py "$build" &&
    tidy_each "$build" "" "$(ls "$build"/merged/*.cpp | grep -v -e _tests. -e /bench_)" &&
    tidy_each "$build" "-clang-analyzer-deadcode.DeadStores" "$(ls "$build"/merged/bench_*.cpp)" &&
    tidy_each "$build" "-clang-analyzer-*" "$(ls "$build"/merged/*_tests.*.cpp)"
}

# tidy_each BUILD CHECKS FILES
tidy_each() {
  xargs -P "$(nproc)" -n 1 clang-tidy-16 --quiet --config-file=.clang-tidy --checks="$2" -p "$1/merged" <<<"$3"
}

run_part() {
  case "$1" in
    release | check | threads) build_and_ctest "$1" ;;
    sanitizers) build_and_ctest sanitize ;;
    format) count_once format check_format ;;
    fuzz) count_once fuzz env FUZZ_SECONDS="${FUZZ_SECONDS:-60}" scripts/fuzz.sh ;;
    headers) count_once headers check_headers ;;
    tidy) count_once tidy check_tidy ;;
    *) echo "test.sh: unknown part '$1'; there is: release, format, check, headers, sanitizers, threads, tidy, fuzz" >&2; exit 2 ;;
  esac
}

for part in "$@"; do
  started=$SECONDS
  echo "== $part"
  run_part "$part"
  echo "== $part took $((SECONDS - started)) s"
done
[[ $skipped -eq 0 ]] || echo "$skipped skipped: what they need is not installed"
echo "$passed passed, $failed failed"
[[ $failed -eq 0 ]]

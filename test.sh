#!/usr/bin/env bash
# Builds everything and runs every test: ./test.sh [arguments of ctest]. The last line is `N passed, N failed`.
source "$(dirname "${BASH_SOURCE[0]}")/cmake/setup.sh"

configure ci
cmake --build "$build" >&2

log=$build/ctest.log
status=0
ctest --test-dir "$build" --no-tests=error --output-on-failure --parallel "$(nproc)" "$@" 2>&1 | tee "$log" || status=$?

# ctest's own count: "97% tests passed, 3 tests failed out of 100"
read -r failed total < <(sed -nE 's/^[0-9]+% tests passed, ([0-9]+) tests? failed out of ([0-9]+)$/\1 \2/p' "$log" | tail -n 1) ||
  { failed=0 total=0; }
((total > 0)) || status=1
echo "$((total - failed)) passed, $failed failed"
exit "$status"

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds everything with sanitizers and runs the tests, then looks at all sources with clang-tidy:
#   test/sanitizers.sh [asan-ubsan|tsan|tidy ...] (all three; an hour each on two cores)
# With the address sanitizer Eigen would allocate otherwise than in PCL's own libraries, if the preset did not
# tell it that malloc aligns.
# SEDR_TESTS is a regular expression of the tests to run (all), SEDR_JOBS how many compilers and tests at a time.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# What other libraries do is not told.
export LSAN_OPTIONS="suppressions=$PWD/test/fuzz/leaks.txt:print_suppressions=0"
export TSAN_OPTIONS="suppressions=$PWD/test/fuzz/races.txt:print_suppressions=0"
jobs=${SEDR_JOBS:-$(nproc)}
kinds=("$@")
[ ${#kinds[@]} -gt 0 ] || kinds=(asan-ubsan tsan tidy)
for kind in "${kinds[@]}"; do
  if [ "$kind" = tidy ]; then
    cmake --preset dev -DSEDR_FAST_BUILD=OFF -B build/tidy > /dev/null
    git ls-files 'sedr_*/src/*.cpp' 'tools/*.cpp' | xargs -P "$jobs" -n 8 clang-tidy --quiet -p build/tidy
    continue
  fi
  cmake --preset "$kind"
  cmake --build --preset "$kind" --parallel "$jobs"
  ctest --preset "$kind" --parallel "$jobs" --timeout 3600 -R "${SEDR_TESTS:-.}"
done

#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the fuzzers and runs each for SECONDS (600), one after the other: run.sh [SECONDS] [FORMAT ...]
# What breaks a reader stays in build/fuzz/found; exit code 1 if there is anything.
set -euo pipefail
cd "$(dirname "$0")/../.."
seconds=${1:-600}
shift || true
formats=("$@")
[ ${#formats[@]} -gt 0 ] || formats=(e57 las pcd ply text)
[ -f build/fuzz/build.ninja ] || cmake --preset fuzz > /dev/null
cmake --build build/fuzz --target fuzzers
result=0
for format in "${formats[@]}"; do
  mkdir -p "build/fuzz/corpus/$format" build/fuzz/found
  "build/fuzz/bin/fuzz_$format" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=4096 -max_len=8192 \
    -print_final_stats=1 -artifact_prefix="build/fuzz/found/$format-" \
    "build/fuzz/corpus/$format" "build/fuzz/fuzz_seeds/$format" \
    2> "build/fuzz/$format.log" || { echo "$format: see build/fuzz/$format.log"; result=1; }
  echo "$format: $(grep -a number_of_executed_units "build/fuzz/$format.log" || true)"
done
exit $result

#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the fuzzers of the readers with clang (two minutes) and runs each for SECONDS (600), one
# after the other: run.sh [SECONDS] [FORMAT ...]. They begin with the files of tests in build/dev. What
# breaks a reader stays in build/reader_fuzzers/found; exit code 1 if there is anything.
set -euo pipefail
cd "$(dirname "$0")/../.."
seconds=${1:-600}
shift || true
formats=("$@")
[ ${#formats[@]} -gt 0 ] || formats=(e57 las pcd ply text)
build=build/reader_fuzzers
[ -f $build/build.ninja ] || cmake -S test/fuzz -B $build -G Ninja -DCMAKE_CXX_COMPILER=clang++ > /dev/null
cmake --build $build
rm -rf $build/seeds
mkdir -p $build/seeds
SEDR_SEEDS=$build/seeds build/dev/bin/test_tools --gtest_filter='ScanFormats.*:ScanOrigins.*:CloudFiles.*' > /dev/null
python3 - $build/seeds <<'END'
import pathlib, sys
MAGIC = {b"ASTM-E57": "e57", b"LASF": "las", b"ply\n": "ply", b"# .PCD": "pcd", b"VERSION": "pcd"}
for file in filter(pathlib.Path.is_file, list(pathlib.Path(sys.argv[1]).iterdir())):
    data = file.read_bytes()
    kind = next((kind for magic, kind in MAGIC.items() if data.startswith(magic)), "text")
    if kind == "e57":  # without the checksums of its pages, which the fuzzer adds
        data = b"".join(data[at:at + 1020] for at in range(0, len(data), 1024))
    (file.parent / kind).mkdir(exist_ok=True)
    file.replace(file.parent / kind / file.name).write_bytes(data)
END
result=0
TIMEFORMAT='  %U s of processor time' # of the user
for format in "${formats[@]}"; do
  mkdir -p "$build/corpus/$format" $build/found
  echo "$format:"
  time "$build/bin/fuzz_$format" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=4096 \
    -max_len=8192 -print_final_stats=1 -artifact_prefix="$build/found/$format-" \
    "$build/corpus/$format" "$build/seeds/$format" 2> "$build/$format.log" ||
    { echo "  see $build/$format.log"; result=1; }
  grep -a 'number_of_executed_units' "$build/$format.log" || true
done
exit $result

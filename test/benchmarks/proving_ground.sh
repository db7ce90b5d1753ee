#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs the proving ground (doc/proving_ground.md) in JOBS processes and makes one table of it:
#
#     test/benchmarks/proving_ground.sh OUT_DIR [JOBS] [options of pcl_sedr_benchmark]
#
# OUT_DIR gets runs_1.csv, runs_2.csv, ..., one a process, and runs.csv, which holds them all. Called
# again with the same JOBS it goes on where it was interrupted. SEDR_BIN is the folder of the programs
# (build/release/bin), SEDR_TABLE the file for the table (OUT_DIR/proving_ground_table.md).
set -euo pipefail

if [ $# -lt 1 ]; then
  sed -n '3,9s/^# \{0,1\}//p' "$0" >&2
  exit 1
fi
out=$1
jobs=${2:-2}
shift $(($# < 2 ? 1 : 2))
case $jobs in
  '' | *[!0-9]* | 0) echo "proving_ground.sh: JOBS must be a number of processes, not '$jobs'" >&2; exit 1 ;;
esac

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
benchmark=${SEDR_BIN:-$root/build/release/bin}/pcl_sedr_benchmark
table=${SEDR_TABLE:-$out/proving_ground_table.md}
if [ ! -x "$benchmark" ]; then
  echo "proving_ground.sh: there is no program $benchmark; SEDR_BIN says where it is" >&2
  exit 1
fi
mkdir -p "$out"

processors=$(nproc)
threads=$((processors > jobs ? processors / jobs : 1))
trap 'kill $(jobs -p) 2>/dev/null || true' EXIT
processes=()
files=()
for ((job = 1; job <= jobs; ++job)); do
  files+=("$out/runs_$job.csv")
  "$benchmark" --part "$job/$jobs" --csv "$out/runs_$job.csv" --resume --threads "$threads" "$@" &
  processes+=($!)
done
for process in "${processes[@]}"; do
  wait "$process"
done

present=()
for file in "${files[@]}"; do
  [ ! -s "$file" ] || present+=("$file") # a part may have no run
done
head -n 1 "${present[0]}" >"$out/runs.csv"
for file in "${present[@]}"; do
  tail -n +2 "$file" >>"$out/runs.csv"
done
"$root/test/benchmarks/proving_ground_table.py" "$out/runs.csv" >"$table.part" # a table of before stays if this fails
mv "$table.part" "$table"
echo "$table"

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Measures what doc/performance.md tells; prints its tables and draws its plots:
#
#     test/benchmarks/performance.sh OUT_DIR [MILLIONS...]
#
# MILLIONS are the sizes of the buildings, in millions of points (10 30 100). What is in OUT_DIR is not measured
# again. SEDR_BIN is the folder of the programs (build/benchmarks/bin), built with -DSEDR_BUILD_BENCHMARKS=ON. Have
# nothing else run beside it: half an hour on two cores with these sizes.
set -euo pipefail

if [ $# -lt 1 ]; then
  sed -n '3,9s/^# \{0,1\}//p' "$0" >&2
  exit 1
fi
out=$1
shift
[ $# -gt 0 ] || set -- 10 30 100
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
bin=${SEDR_BIN:-$here/../../build/benchmarks/bin}
mkdir -p "$out"

# measure FILE COMMAND...: what google-benchmark finds, unless it is known.
measure() {
  local file=$out/$1.json
  shift
  [ -s "$file" ] || "$@" --benchmark_out="$file.part" --benchmark_out_format=json \
    --benchmark_report_aggregates_only=true >&2
  [ -s "$file" ] || mv "$file.part" "$file"
}

# What is compared runs in turn, as machines slow down and recover.
in_turn=--benchmark_enable_random_interleaving=true

for cloud in 3/random:0 30/random:0 50/random:0 30/random:1 50/random:1; do
  measure "thinning_${cloud/\/random:/_}" "$bin/benchmark_parallel_voxel_grid" $in_turn \
    --benchmark_filter="^(VoxelGrid|ApproximateVoxelGrid|ParallelVoxelGrid)/Mpoints:$cloud"
done
measure stages "$bin/benchmark_stages"
for scene in bls_room hls_hall syn_flat; do
  [ -s "$out/$scene/scan.pcd" ] || "$bin/pcl_simulate_indoor_scan" "$scene" "$out/$scene" --noise 0.01 >&2
  measure "chain_$scene" "$bin/benchmark_chain" "$out/$scene/scan.pcd" $in_turn
done
# The way to the plan at 3 and 30 million points: scene, rays of a scanner position, name.
while read -r scene rays name; do
  [ -s "$out/plan_$name.json" ] ||
    "$bin/pcl_simulate_indoor_scan" "$scene" "$out/$name" --rays "$rays" --noise 0.01 >&2
  measure "plan_$name" "$bin/benchmark_chain" "$out/$name/scan.pcd" \
    --benchmark_filter="^(Reading|VoxelGrid|SedrToThePlan)/" $in_turn
  rm -rf "${out:?}/$name"
done <<'SCENES'
bls_room 47000 bls_room_3
hls_hall 37700 hls_hall_3
syn_flat 375500 syn_flat_3
bls_room 470000 bls_room_30
hls_hall 377000 hls_hall_30
syn_flat 3755000 syn_flat_30
SCENES
[ -s "$out/buildings.csv" ] ||
  "$here/building_costs.py" "$out/buildings.csv" --bin "$bin" --folder "$out" --millions "$@" >&2
exec python3 "$here/performance_tables.py" "$out"

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Repeats the experiments of the paper (section 3) for doc/evaluation.md: its settings, and its Figures 8 to 11 on the
# simulated scenes that stand for its scans. Prints every command, then the tables of the page, and puts the
# pictures into doc/images. With a folder SEDR_DATA that has synth1.pcd and synth1_rooms.obj, the paper's own
# synthetic scene is done too.
#   [SEDR_DATA=FOLDER_OF_SCANS] doc/evaluation.sh BIN OUTPUT_DIR
set -euo pipefail
if [ $# -ne 2 ]; then
  echo "Usage: [SEDR_DATA=FOLDER_OF_SCANS] $0 BIN OUTPUT_DIR" >&2
  exit 1
fi
doc=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=doc/rendering.sh
. "$doc/rendering.sh"
PATH=$(cd "$1" && pwd):$PATH
if ! command -v pcl_sedr >/dev/null; then
  echo "$0: no pcl_sedr in '$1'; build it first, see README.md" >&2
  exit 1
fi
mkdir -p "$2"
cd "$2"

# run COMMAND...: prints it as it can be typed in OUTPUT_DIR, and runs it.
run() {
  echo "\$ $*"
  "$@"
}

# reconstruct SCENE MODEL OPTIONS...: the same for pcl_sedr; keeps the processor's seconds too.
reconstruct() {
  local scene=$1 model=$2 TIMEFORMAT="%U %S"
  shift 2
  { time run pcl_sedr "$scene/scan.pcd" "$scene/$model" "$@" 2>&3; } 3>&2 2>"$scene/$model.seconds"
}

# Table 1 of the paper.
common=(--voxel-size 0.05)
bls=(--plane-tolerance 0.07 --boundary-tolerance 0.05)
hls=(--plane-tolerance 0.1 --boundary-tolerance 0.05)
syn=(--plane-tolerance 0.1 --boundary-tolerance 0.01)

# evaluate SCENE TRUTH POINTS... -- SETTINGS...: the scan with our defaults, with the paper's settings, and with
# pcl::Poisson besides; POINTS are the options that tell the points of the structure from all others.
evaluate() {
  local scene=$1 truth=$1/$2 points=() model
  shift 2
  while [ "$1" != -- ]; do points+=("$1"); shift; done
  shift
  points=(--cloud "$scene/scan.pcd" "${points[@]}")
  reconstruct "$scene" default
  reconstruct "$scene" paper "$@" "${common[@]}"
  mkdir -p "$scene/paper_pcl"
  run benchmark_poisson_solvers "$scene/paper/structure.pcd" "$scene/paper_pcl/mesh.ply"
  for model in default paper paper_pcl; do
    run pcl_mesh_evaluation "$scene/$model/mesh.ply" --truth "$truth" "${points[@]}" \
      --json "$scene/$model.json" | grep -E '^\$|cm |to '
  done
  run pcl_mesh_evaluation "$truth" "${points[@]}" --json "$scene/truth_itself.json" | grep -E '^\$|cm |to '
}

for scene in bls_room hls_hall syn_flat columns; do
  run pcl_simulate_indoor_scan "$scene" "$scene"
done
structure=(--labels "1,2,3,4,5")
evaluate bls_room truth.ply "${structure[@]}" -- "${bls[@]}"
evaluate hls_hall truth.ply "${structure[@]}" -- "${hls[@]}"
evaluate syn_flat truth.ply "${structure[@]}" -- "${syn[@]}"
if [ -f "${SEDR_DATA:-}/synth1.pcd" ]; then
  mkdir -p synth1
  ln -sf "$(realpath "$SEDR_DATA")/synth1.pcd" synth1/scan.pcd
  ln -sf "$(realpath "$SEDR_DATA")/synth1_rooms.obj" synth1/truth.obj
  run pcl_parallel_voxel_grid synth1/scan.pcd synth1/scan_copy.pcd --leaf 0.005 --scan-axes # for the pictures
  evaluate synth1 truth.obj --near synth1/truth.obj -- "${syn[@]}"
  walls=(--cloud synth1/scan.pcd --labels 2 --near synth1/truth.obj)
  for model in default/mesh.ply paper_pcl/mesh.ply truth.obj; do
    run pcl_mesh_evaluation "synth1/$model" "${walls[@]}" | grep -E '^\$|cm |to '
  done
else
  echo "synth1: no SEDR_DATA with synth1.pcd, left out"
fi

echo "== Figure 8: the study without its details, as a method has it that knows walls, one ceiling and one floor"
run /usr/bin/python3 "$doc/evaluation.py" without_details bls_room/default/floorplan.json bls_room/plain.json
run pcl_floorplan_extrusion bls_room/plain.json bls_room/plain.ply
for solid in plain default/solid; do
  run pcl_mesh_evaluation "bls_room/$solid.ply" --truth bls_room/truth.ply | grep -E '^\$|cm |to '
done

echo "== Figure 9: objects that stop short of the ceiling"
run pcl_sedr columns/scan.pcd columns/default --no-mesh
for top in 3.10 3.30 3.40 3.45 3.50 3.55; do
  echo "\$ the scene hls_hall with its cabinet $top m high, its ceiling at 3.6 m, in cabinet_$top.json"
  pcl_simulate_indoor_scan --print hls_hall |
    sed "s/\(\"tall cabinet\", .*\"size\": \[0.8, 0.8, \)3.1\]/\1$top]/" >"cabinet_$top.json"
  run pcl_simulate_indoor_scan "cabinet_$top.json" "cabinet_$top"
  run pcl_sedr "cabinet_$top/scan.pcd" "cabinet_$top/default" --no-mesh
done

echo "== The tables of the page"
/usr/bin/python3 "$doc/evaluation.py" tables .
echo "== The pictures of the page"
render "$doc/evaluation.py" pictures . "$doc/images"

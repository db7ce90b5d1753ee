#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes the figures and pictures of doc/real_scans.md: reconstructs the scans in the folder
# SEDR_DATA with the programs in BIN, prints what the page says, and puts the pictures into
# doc/images.
set -euo pipefail
if [ $# -ne 2 ] || [ -z "${SEDR_DATA:-}" ]; then
  echo "Usage: SEDR_DATA=FOLDER_OF_SCANS $0 BIN OUTPUT_DIR" >&2
  exit 1
fi
bin=$(cd "$1" && pwd)
out=$2
images=$(cd "$(dirname "$0")" && pwd)/images
mkdir -p "$out"

for scan in synth1 office_labelled stepped_room apartment vaulted_studio; do
  [ -f "$SEDR_DATA/$scan.pcd" ] || { echo "$scan: not there, left out"; continue; }
  echo "== $scan"
  "$bin/pcl_sedr" "$SEDR_DATA/$scan.pcd" "$out/$scan" --pictures
  "$bin/pcl_mesh_evaluation" "$out/$scan/mesh.ply" --cloud "$SEDR_DATA/$scan.pcd"
  "$bin/pcl_mesh_evaluation" "$out/$scan/solid.ply" --self-intersections | grep -E 'closed|triangles|intersect' || true
  cp "$out/$scan/floorplan.svg" "$images/real_${scan}_drawing.svg"
  cp "$out/$scan/pictures/floorplan_fitting.png" "$images/real_${scan}_plan.png"
  xvfb-run -a "$bin/pcl_sedr_viewer" "$out/$scan" --layers mesh --screenshot "$images/real_${scan}_mesh.png"
done

echo "== synth1: wall points within 5 cm of the reference walls, from the model and from these walls"
walls=(--cloud "$SEDR_DATA/synth1.pcd" --labels 2 --near "$SEDR_DATA/synth1_rooms.obj")
"$bin/pcl_mesh_evaluation" "$out/synth1/mesh.ply" "${walls[@]}" | tail -2
"$bin/pcl_mesh_evaluation" "$SEDR_DATA/synth1_rooms.obj" "${walls[@]}" | tail -2
echo "-- within 3 cm of the reference"
"$bin/pcl_mesh_evaluation" "$out/synth1/mesh.ply" "${walls[@]}" --near-distance 0.03 | tail -2

echo "== office_labelled: labels, the structure's against the scan's"
for off in 0 0.03 0.02 0.01; do
  echo "-- no farther off the surface than $off m (0: any)"
  /usr/bin/python3 "$(dirname "$0")/../test/benchmarks/label_grades.py" "$out/office_labelled/structure.pcd" --off-surface "$off" \
    "$SEDR_DATA/office_labelled.pcd" --map 0=1,1=2,2=3,3=3,4=3,5=3,6=3
done

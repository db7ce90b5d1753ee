#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes the pictures of README.md and of the class pages anew: simulates the scenes, runs every
# stage on them, and draws what came out.
#   doc/make_images.sh [BIN [OUTPUT]]
# BIN     folder of the built programs (build/release/bin)
# OUTPUT  folder for the pictures (doc/images)
# Debian packages: python3-numpy python3-matplotlib python3-vtk9 python3-pil xvfb xauth
set -euo pipefail

fail() { echo "$0: $*" >&2; exit 1; }

[ $# -le 2 ] || fail "usage: $0 [BIN [OUTPUT]]"
root=$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")
bin=$(realpath -m "${1-$root/build/release/bin}")
output=$(realpath -m "${2-$root/doc/images}")
[ -x "$bin/pcl_sedr" ] || fail "no pcl_sedr in '$bin'; build it first, see README.md"

missing=()
for package in python3-numpy python3-matplotlib python3-vtk9 python3-pil xvfb xauth; do
  status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] || fail "needs the Debian packages ${missing[*]}"

data=$(mktemp -d)
trap 'rm -rf "$data"' EXIT

run() { "$bin/$1" "${@:2}"; }

# Every file is named after the stage that wrote it.
run_stages() {
  local d=$data/$1
  run pcl_parallel_voxel_grid           "$d/scan.pcd"    "$d/thinned.pcd"
  run pcl_horizontal_plane_detection    "$d/thinned.pcd" "$d/planes.pcd"
  run pcl_grid_region_outlier_removal   "$d/planes.pcd"  "$d/rooms.pcd"
  run pcl_grid_slice_detail             "$d/rooms.pcd"   "$d/details.pcd"
  run pcl_floor_projection_recovery     "$d/details.pcd" "$d/floor.pcd"
  run pcl_ceiling_boundary_wall_growing "$d/floor.pcd"   "$d/walls.pcd"
  run pcl_floorplan_fitting             "$d/walls.pcd"   "$d/plan.json"
  run pcl_structure_refinement          "$d/walls.pcd"   "$d/plan.json" "$d/refined.pcd"
  run pcl_vertical_hole_repair          "$d/refined.pcd" "$d/plan.json" "$d/repaired.pcd"
}

for scene in bls_room hls_hall syn_flat; do
  echo "== $scene"
  run pcl_simulate_indoor_scan "$scene" "$data/$scene"
  run pcl_sedr "$data/$scene/scan.pcd" "$data/$scene/model"
  run_stages "$scene"
done

echo "== drawing"
mkdir -p "$output"
xvfb-run -a -s "-screen 0 1600x1200x24" /usr/bin/python3 "$root/doc/make_images.py" "$data" "$output"

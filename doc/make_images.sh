#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes the pictures of README.md and of the class pages anew: simulates the scenes, and runs every
# stage on them with --picture. What the viewer shows, and the three renderings in perspective, are made
# where their packages are.
#   doc/make_images.sh [BIN [OUTPUT]]
# BIN     folder of the built programs (build/release/bin)
# OUTPUT  folder for the pictures (doc/images)
# Debian packages of the viewer's pictures: xvfb xauth; of those of report.html: chromium libjs-three
# python3-pil; of the renderings: xvfb xauth python3-numpy
# python3-matplotlib python3-vtk9 python3-pil
set -euo pipefail

fail() { echo "$0: $*" >&2; exit 1; }

[ $# -le 2 ] || fail "usage: $0 [BIN [OUTPUT]]"
root=$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")
bin=$(realpath -m "${1-$root/build/release/bin}")
output=$(realpath -m "${2-$root/doc/images}")
[ -x "$bin/pcl_sedr" ] || fail "no pcl_sedr in '$bin'; build it first, see README.md"

data=$(mktemp -d)
trap 'rm -rf "$data"' EXIT
mkdir -p "$output"

# The pictures that the pages show: stage, scene, name of the file.
shown="
parallel_voxel_grid           bls_room parallel_voxel_grid
room_segmentation             syn_flat room_segmentation
grid_slice_detail             bls_room grid_slice_detail
floor_projection_recovery     syn_flat floor_projection_recovery
ceiling_boundary_wall_growing bls_room ceiling_boundary_wall_growing
floorplan_fitting             hls_hall floorplan_fitting
floorplan_fitting             syn_flat floorplan_fitting_flat
structure_refinement          hls_hall structure_refinement
vertical_hole_repair          syn_flat vertical_hole_repair
"

# stage NAME SCENE FILES...: runs a stage, with its picture if a page shows it.
stage() {
  local name=$1 scene=$2 picture
  picture=$(awk -v s="$name" -v c="$scene" '$1 == s && $2 == c { print $3 }' <<<"$shown")
  "$bin/pcl_$name" "${@:3}" ${picture:+--picture "$output/$picture.png"} >/dev/null
}

for scene in bls_room hls_hall syn_flat; do
  echo "== $scene"
  d=$data/$scene
  "$bin/pcl_simulate_indoor_scan" "$scene" "$d"
  stage parallel_voxel_grid           $scene "$d/scan.pcd"    "$d/thinned.pcd"
  stage room_segmentation             $scene "$d/thinned.pcd" "$d/rooms.pcd" --building "$d/building.json"
  stage grid_slice_detail             $scene "$d/rooms.pcd"   "$d/details.pcd"
  stage floor_projection_recovery     $scene "$d/details.pcd" "$d/floor.pcd"
  stage ceiling_boundary_wall_growing $scene "$d/floor.pcd"   "$d/walls.pcd"
  stage floorplan_fitting             $scene "$d/walls.pcd"   "$d/plan.json" --building "$d/building.json"
  stage structure_refinement          $scene "$d/walls.pcd"   "$d/plan.json" "$d/refined.pcd"
  stage vertical_hole_repair          $scene "$d/refined.pcd" "$d/plan.json" "$d/repaired.pcd"
done

# What the chain does not go through: planes of a whole scan, and regions of its ceilings.
for scene in bls_room syn_flat; do
  d=$data/$scene
  flat=$([ $scene = syn_flat ] && echo _flat || true)
  "$bin/pcl_horizontal_plane_detection" "$d/thinned.pcd" "$d/levels.pcd" \
    --picture "$output/horizontal_plane_detection$flat.png" >/dev/null
  "$bin/pcl_grid_region_outlier_removal" "$d/levels.pcd" "$d/regions.pcd" \
    --picture "$output/grid_region_outlier_removal$flat.png" >/dev/null
done
rm "$output/horizontal_plane_detection_flat.png"

echo "== comparison"
for state in before after; do
  "$bin/pcl_simulate_indoor_scan" "$root/doc/scenes/office_$state.json" "$data/office_$state"
  "$bin/pcl_sedr" "$data/office_$state/scan.pcd" "$data/office_$state/model"
done
"$bin/pcl_structure_compare" "$data"/office_{before,after}/model --picture "$output/structure_compare.png"

echo "== models"
"$bin/pcl_simulate_indoor_scan" bls_room "$data/noisy_room" --rays 6000 --noise 0.04
for scene in bls_room hls_hall syn_flat noisy_room; do
  (cd "$data/$scene" && "$bin/pcl_sedr" scan.pcd model --report) # the page shows the scan's path
done
cp "$data/syn_flat/model/floorplan.svg" "$output/floorplan_drawing.svg"

# look NAME SCENE/INPUT OPTIONS...: what the viewer shows, for its page.
look() {
  xvfb-run -a "$bin/pcl_sedr_viewer" "$data/$2" --size 640x440 --screenshot "$output/sedr_viewer_$1.png" "${@:3}"
}

if command -v xvfb-run >/dev/null && [ -x "$bin/pcl_sedr_viewer" ]; then
  echo "== the viewer"
  look label     bls_room/model --layers structure
  look distance  bls_room/model --layers scan --colour distance
  look solid     syn_flat/model --layers solid --colour room
  look stage     hls_hall/walls.pcd --colour label
  look mesh      hls_hall/model --layers mesh
  mv "$output/sedr_viewer_mesh.png" "$output/structural_poisson.png"
else
  echo "The viewer's pictures stay as they are: they need the Debian packages xvfb and xauth."
fi

if command -v chromium >/dev/null; then
  echo "== report.html in a browser"
  /usr/bin/python3 "$root/doc/report_images.py" "$data" "$output"
else
  echo "The report's pictures stay as they are: they need the Debian packages chromium and python3-pil."
fi

echo "== rendering"
# shellcheck source=doc/rendering.sh
. "$root/doc/rendering.sh"
render "$root/doc/make_images.py" "$data" "$output"

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# From a bare Debian 12 to a first model: installs what is missing, builds the programs, simulates
# the scan of a room, reconstructs it and compares the model with the truth. May be run again.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

jobs=${SEDR_JOBS:-$(nproc)}
bin=build/release/bin
scene=build/quickstart/bls_room

step() { printf '\n== %s\n' "$*"; }

step "Installing what is missing"
bash tools/install_dependencies.sh

step "Building (some minutes the first time)"
cmake --preset release -DSEDR_BUILD_TESTS=OFF
cmake --build --preset release --parallel "$jobs"

step "Simulating the scan of a study with a soffit and a recess"
"$bin/pcl_simulate_indoor_scan" bls_room "$scene"

step "Reconstructing it"
"$bin/pcl_sedr" "$scene/scan.pcd" "$scene/model" --report

step "Comparing the model with the truth"
"$bin/pcl_mesh_evaluation" "$scene/model/mesh.ply" --truth "$scene/truth.ply"

step "Done. Look at"
cat <<TEXT
  $scene/scan.pcd              the scan
  $scene/model/mesh.ply        the model: closed, ceiling, floor and walls
  $scene/model/structure.pcd   the points of the structure, label and room of each
  $scene/model/floorplan.json  walls, columns, details and heights as numbers
  $scene/model/report.json     what was done, with figures
  $scene/model/report.html     all of it on one page, for a browser
  $scene/truth.ply             what was simulated
All of it together: $bin/pcl_sedr_viewer $scene/model   (needs a screen; key h tells all keys)
Your own scan: $bin/pcl_sedr SCAN.pcd OUTPUT_DIR   (metres, z up; -h tells all options)
TEXT

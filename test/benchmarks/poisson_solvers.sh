#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Compares StructuralPoisson with pcl::Poisson on the scenes of the proving ground: time of the processor,
# whether the mesh is closed, and its distances from the truth.
#
#     test/benchmarks/poisson_solvers.sh OUT_DIR [options of proving_ground.py]
#
# OUT_DIR/runs keeps the scans, truths and structures; what is there is not made again. SEDR_BIN is the
# folder of the programs (build/release/bin), which `ninja benchmark_poisson_solvers` adds to.
set -euo pipefail

if [ $# -lt 1 ]; then
  sed -n '3,9s/^# \{0,1\}//p' "$0" >&2
  exit 1
fi
out=$1
shift
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
bin=${SEDR_BIN:-$root/build/release/bin}
mkdir -p "$out/runs"
/usr/bin/python3 "$root/test/benchmarks/proving_ground.py" "$out/runs.csv" --bin "$bin" --no-mesh --noise 0.001,0.02 --seeds 1 \
  --keep "$out/runs" "$@" >&2
TIMEFORMAT='%U s of the processor'
for run in "$out"/runs/*; do
  for solver in benchmark_poisson_solvers pcl_structural_poisson; do
    echo "$(basename "$run"), $solver:"
    time "$bin/$solver" "$run/out/structure.pcd" "$run/$solver.ply" > "$run/$solver.log"
    "$bin/pcl_mesh_evaluation" "$run/$solver.ply" --truth "$run/truth.ply"
  done
done

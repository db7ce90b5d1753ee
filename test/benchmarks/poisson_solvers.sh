#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Compares StructuralPoisson with pcl::Poisson on the scenes of the proving ground; prints the table of
# doc/structural_poisson.md, of each figure that of pcl::Poisson first:
#
#     test/benchmarks/poisson_solvers.sh OUT_DIR [RUNS] [THREADS] [options of proving_ground.py]
#
# Seconds are the median of RUNS runs (5): of the processor with one thread, by the clock with more (0, all).
# OUT_DIR/runs keeps the scans, truths and structures; what is there is not made again. SEDR_BIN is the
# folder of the programs (build/release/bin), which `ninja benchmark_poisson_solvers` adds to.
set -euo pipefail

if [ $# -lt 1 ]; then
  sed -n '3,10s/^# \{0,1\}//p' "$0" >&2
  exit 1
fi
out=$1
runs=${2:-5}
threads=${3:-0}
shift $(($# < 3 ? $# : 3))
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
bin=${SEDR_BIN:-$root/build/release/bin}
if [ ! -x "$bin/benchmark_poisson_solvers" ]; then
  echo "poisson_solvers.sh: there is no program $bin/benchmark_poisson_solvers; SEDR_BIN says where it is" >&2
  exit 1
fi
mkdir -p "$out/runs"
/usr/bin/python3 "$root/test/benchmarks/proving_ground.py" "$out/runs.csv" --bin "$bin" --no-mesh --noise 0.001,0.02 --seeds 1 \
  --keep "$out/runs" "$@" >&2
"$bin/benchmark_poisson_solvers" "$runs" "$threads" "$out"/runs/*

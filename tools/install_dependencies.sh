#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs what a Debian 12 lacks to build SEDR, and nothing that is there already.
#   tools/install_dependencies.sh [--with-tests] [--with-benchmarks] [--with-docs] [--with-mpi]
set -euo pipefail

with_tests=no
with_benchmarks=no
with_docs=no
with_mpi=no
for argument in "$@"; do
  case "$argument" in
    --with-tests) with_tests=yes ;;
    --with-benchmarks) with_benchmarks=yes ;;
    --with-docs) with_docs=yes ;;
    --with-mpi) with_mpi=yes ;;
    *) echo "usage: $0 [--with-tests] [--with-benchmarks] [--with-docs] [--with-mpi]" >&2; exit 1 ;;
  esac
done

# package             why
needed=(
  "g++                 compiles; brings the C compiler that VTK's CMake files ask for"
  "cmake               configures the build"
  "ninja-build         runs it"
  "libpcl-dev          the Point Cloud Library and its visualizer; brings Eigen, FLANN, Boost and VTK"
  "nlohmann-json3-dev  reads and writes JSON"
  "libembree-dev       casts the rays of the scan simulator, which is not built without it"
  "libcairo2-dev       draws plans and pictures as SVG, PDF and PNG"
  "pkg-config          finds it"
  "fonts-liberation    the letters there: as wide as Helvetica and Arial on any machine"
  "libjs-three         turns the model in report.html; not needed to build"
)
# Chromium (300 MB) is not among them: without it the test that opens report.html in a browser is skipped.
if [ "$with_tests" = yes ]; then
  needed+=(
    "libgtest-dev        GoogleTest, for the tests"
    "mold                links them in a fifth of the time"
    "xvfb                tests look at the viewer's window without a screen"
    "xauth               xvfb-run needs it"
    "python3             tests read solids, drawings and report.html back"
    "python3-ezdxf       reads the DXF there"
    "python3-numpy       tests measure models and grade random buildings with it"
    "python3-scipy       likewise"
    "python3-shapely     likewise"
    "librsvg2-bin        draws the SVG there"
    "poppler-utils       reads the PDF there"
  )
fi
if [ "$with_benchmarks" = yes ]; then
  needed+=(
    "python3-numpy       makes scans for performance.py"
    "python3-matplotlib  draws its plots"
  )
fi
if [ "$with_docs" = yes ]; then
  needed+=(
    "python3-sphinx      makes HTML of doc/"
    "python3-myst-parser reads its Markdown there"
    "doxygen             makes the API reference"
  )
fi

if [ "$with_mpi" = yes ]; then
  needed+=(
    "libopenmpi-dev             MPI, for pcl_sedr_mpi"
    "openmpi-bin                mpirun, which starts it"
    "libboost-mpi-dev           its C++ interface"
    "libboost-serialization-dev makes bytes of what its processes send each other"
  )
fi

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "This system has no apt-get, so nothing is installed. SEDR needs what these Debian packages hold:"
  printf '  %s\n' "${needed[@]}"
  exit 0
fi

missing=()
for line in "${needed[@]}"; do
  package=${line%% *}
  status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] && continue
  [ ${#missing[@]} -gt 0 ] || echo "Missing packages, to be installed:"
  echo "  $line"
  missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "Neither root nor sudo: have an administrator run: apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
# `env`, as sudo drops variables of its caller; the lock may be held by a system's own updates.
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q
  -o Acquire::Retries=3 -o DPkg::Lock::Timeout=300)
"${apt[@]}" update
"${apt[@]}" install -y --no-install-recommends "${missing[@]}"

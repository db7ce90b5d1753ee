#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs what is missing, builds everything and runs all tests. SEDR_JOBS sets how many compilers
# and tests run at a time (as many as there are processors), SEDR_DATA where real scans lie; tests
# on them are skipped without.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

jobs=${SEDR_JOBS:-$(nproc)}
export SEDR_DATA=${SEDR_DATA:-$PWD/../shared/data}
[ -d "$SEDR_DATA" ] || echo "No folder $SEDR_DATA: tests on real scans will be skipped."

bash tools/install_dependencies.sh --with-tests --with-docs --with-mpi

cmake --preset dev -DSEDR_BUILD_TESTS=ON
cmake --build --preset dev --parallel "$jobs"
ctest --preset dev --parallel "$jobs"

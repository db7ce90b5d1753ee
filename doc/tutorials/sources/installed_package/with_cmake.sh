#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# with_cmake.sh: PREFIX is where SEDR was installed, SOURCES the folder of this file.
set -eu
cmake -S "$SOURCES" -B build -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$PREFIX"
cmake --build build
sh "$SOURCES/box.sh" | build/levels

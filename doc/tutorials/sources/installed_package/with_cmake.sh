#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# PREFIX is where SEDR was installed, SOURCES the folder of all tutorials.
set -eu
cmake -S "$SOURCES/installed_package" -B build -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$PREFIX"
cmake --build build
sh "$SOURCES/installed_package/box.sh" | build/levels

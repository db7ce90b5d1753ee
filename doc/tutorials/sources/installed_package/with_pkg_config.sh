#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# PREFIX is where SEDR was installed, SOURCES the folder of all tutorials.
set -eu
lib=$(dirname "$(find "$PREFIX" -name sedr_segmentation.pc)")/..
export PKG_CONFIG_PATH="$lib/pkgconfig"
# Flags are lists of words.
# shellcheck disable=SC2046,SC2086
g++ -std=c++17 ${CXXFLAGS--O2} "$SOURCES/installed_package/levels.cpp" \
  $(pkg-config --cflags --libs sedr_segmentation) -Wl,-rpath,"$lib" -o levels
sh "$SOURCES/installed_package/box.sh" | ./levels

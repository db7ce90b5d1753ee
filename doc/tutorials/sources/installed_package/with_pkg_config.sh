#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# with_pkg_config.sh: PREFIX is where SEDR was installed, SOURCES the folder of this file.
set -eu
lib=$(dirname "$(find "$PREFIX" -name sedr_segmentation.pc)")/..
export PKG_CONFIG_PATH="$lib/pkgconfig"
# Flags are lists of words.
# shellcheck disable=SC2046
g++ -std=c++17 -O2 "$SOURCES/levels.cpp" \
  $(pkg-config --cflags --libs sedr_segmentation) -Wl,-rpath,"$lib" -o levels
sh "$SOURCES/box.sh" | ./levels

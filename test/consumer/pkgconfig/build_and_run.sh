#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# build_and_run.sh MAIN.cpp PROGRAM: what a user without CMake writes.
set -eu
# Flags are lists of words.
# shellcheck disable=SC2046,SC2086
"$CXX" -std=c++17 $CXXFLAGS "$1" $("$PKG_CONFIG" --cflags --libs sedr_segmentation) -o "$2"
"$2"

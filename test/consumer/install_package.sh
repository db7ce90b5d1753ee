#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# install_package.sh CPACK BUILD_DIR FOLDER: makes the Debian package of a build and unpacks it.
set -eu
mkdir -p "$3"
# By gzip: xz takes 14 s of a processor more.
"$1" --config "$2/CPackConfig.cmake" -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip -B "$3/package" > "$3/cpack.log" || { cat "$3/cpack.log"; exit 1; }
dpkg-deb --info "$3"/package/*.deb
dpkg-deb -x "$3"/package/*.deb "$3"

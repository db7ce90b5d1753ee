#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
command -v CloudCompare >/dev/null || exit 77
python3 "$SOURCES/large_coordinates/make_las.py" "$STUDY/scan.pcd" scan.xyz 691600 5336000
export QT_QPA_PLATFORM=offscreen
# [convert]
CloudCompare -SILENT -NO_TIMESTAMP -C_EXPORT_FMT PLY \
  -O -GLOBAL_SHIFT -691600 -5335900 0 scan.xyz -DROP_GLOBAL_SHIFT -SAVE_CLOUDS
pcl_sedr scan.ply model
# [convert]

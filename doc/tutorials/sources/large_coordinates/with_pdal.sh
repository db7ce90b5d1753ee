#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
command -v pdal >/dev/null || exit 77
python3 "$SOURCES/large_coordinates/make_las.py" "$STUDY/scan.pcd" scan.las 691600 5336000
cp "$SOURCES/large_coordinates/las_to_pcd.json" .
# [convert]
pdal pipeline las_to_pcd.json
pcl_sedr scan.pcd model
# [convert]

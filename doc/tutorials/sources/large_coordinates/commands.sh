#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A LAS file as a surveyor might give it, of the scan in study.
python3 "$SOURCES/large_coordinates/make_las.py" "$STUDY/scan.pcd" scan.las 691600 5336000
# [convert]
las_to_pcd scan.las scan.pcd
pcl_sedr scan.pcd model
# [convert]
# [back]
move_mesh model/solid.ply solid_in_place.ply 691600 5335900 0
# [back]

#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A LAS file as a surveyor might give it, of the scan in study.
python3 "$SOURCES/large_coordinates/make_las.py" "$STUDY/scan.pcd" scan.las 691600 5336000
# [model]
pcl_sedr scan.las model
# [model]
grep -q '"origin"' model/report.json
# [frame]
pcl_sedr scan.las later --origin model
pcl_structure_compare model later
# [frame]
# [back]
move_mesh model/solid.ply solid_in_place.ply
# [back]

#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# [stages]
pcl_parallel_voxel_grid           scan.pcd    thinned.pcd
pcl_room_segmentation             thinned.pcd rooms.pcd --building building.json
pcl_grid_slice_detail             rooms.pcd   details.pcd
pcl_floor_projection_recovery     details.pcd floor.pcd
pcl_ceiling_boundary_wall_growing floor.pcd   walls.pcd
pcl_floorplan_fitting             walls.pcd   floorplan.json --raw scan.pcd --building building.json
pcl_opening_detection             scan.pcd    floorplan.json floorplan.json
pcl_structure_refinement          walls.pcd   floorplan.json refined.pcd
pcl_vertical_hole_repair          refined.pcd floorplan.json structure.pcd
pcl_structural_poisson            structure.pcd mesh.ply
pcl_floorplan_extrusion           floorplan.json solid.ply
# [stages]
# [judge]
pcl_mesh_evaluation               mesh.ply --truth truth.ply
# [judge]

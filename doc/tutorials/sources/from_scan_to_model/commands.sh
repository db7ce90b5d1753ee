#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# [run]
pcl_sedr study/scan.pcd study/model
# [run]
# [judge]
pcl_mesh_evaluation study/model/mesh.ply --truth study/truth.ply
# [judge]

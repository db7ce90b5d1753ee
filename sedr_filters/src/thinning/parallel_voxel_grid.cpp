// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/impl/instantiate.hpp>
#include <pcl/sedr_filters/impl/parallel_voxel_grid.hpp>

PCL_INSTANTIATE(ParallelVoxelGrid, SEDR_POINT_TYPES)

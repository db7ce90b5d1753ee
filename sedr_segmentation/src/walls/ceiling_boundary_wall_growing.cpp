// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_segmentation/impl/ceiling_boundary_wall_growing.hpp>

#include <pcl/impl/instantiate.hpp>

PCL_INSTANTIATE(CeilingBoundaryWallGrowing, SEDR_POINT_TYPES)

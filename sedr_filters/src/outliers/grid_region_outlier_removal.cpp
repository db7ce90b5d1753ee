// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/impl/instantiate.hpp>
#include <pcl/sedr_filters/impl/grid_region_outlier_removal.hpp>
#include <pcl/sedr_filters/point_types.h>

PCL_INSTANTIATE(GridRegionOutlierRemoval, SEDR_POINT_TYPES)

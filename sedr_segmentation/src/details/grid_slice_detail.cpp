// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/impl/grid_slice_detail.hpp>

#include <pcl/impl/instantiate.hpp>
#include <pcl/impl/pcl_base.hpp>

PCL_INSTANTIATE(GridSliceDetail, SEDR_POINT_TYPES)

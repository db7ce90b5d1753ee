// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/impl/horizontal_plane_detection.hpp>

#include <pcl/impl/instantiate.hpp>
#include <pcl/impl/pcl_base.hpp>

PCL_INSTANTIATE(HorizontalPlaneDetection, SEDR_POINT_TYPES)

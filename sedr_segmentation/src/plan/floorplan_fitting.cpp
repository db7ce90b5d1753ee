// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/impl/floorplan_fitting.hpp>

#include <pcl/impl/instantiate.hpp>
#include <pcl/impl/pcl_base.hpp>

PCL_INSTANTIATE(FloorplanFitting, SEDR_POINT_TYPES)

// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/impl/room_segmentation.hpp>

#include <pcl/impl/instantiate.hpp>
#include <pcl/impl/pcl_base.hpp>

PCL_INSTANTIATE(RoomSegmentation, SEDR_POINT_TYPES)

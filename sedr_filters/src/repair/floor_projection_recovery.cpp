// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/impl/instantiate.hpp>
#include <pcl/sedr_filters/impl/floor_projection_recovery.hpp>

PCL_INSTANTIATE(FloorProjectionRecovery, SEDR_POINT_TYPES)

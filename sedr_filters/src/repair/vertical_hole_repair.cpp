// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/impl/vertical_hole_repair.hpp>

#include <pcl/impl/instantiate.hpp>

PCL_INSTANTIATE(VerticalHoleRepair, SEDR_POINT_TYPES)

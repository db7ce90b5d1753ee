// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/pcl_macros.h>
#include <pcl/point_types.h>
#include <pcl/register_point_struct.h>

#include <cstdint>

/** @brief A point as our scanner writes it: place, what a person took it for, time. */
struct EIGEN_ALIGN16 ScanPoint {
  PCL_ADD_POINT4D              // x, y, z, and padding for SSE
      std::uint32_t label = 0; ///< a pcl::sedr::StructureLabel
  float seconds = 0;           ///< since the scan began
  PCL_MAKE_ALIGNED_OPERATOR_NEW

  ScanPoint()
      : data{0, 0, 0, 1}
  {}
};

// clang-format off
POINT_CLOUD_REGISTER_POINT_STRUCT(ScanPoint,
  (float, x, x)(float, y, y)(float, z, z)
  (std::uint32_t, label, label)
  (float, seconds, seconds))
// clang-format on

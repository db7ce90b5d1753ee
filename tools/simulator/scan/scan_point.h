// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace pcl::sedr::sim {

/** @brief One record of a scan, in the layout of the file. */
struct ScanPoint {
  float x = 0.0F;
  float y = 0.0F;
  float z = 0.0F;
  std::uint32_t label = 0; ///< see Label
  std::uint32_t room = 0;  ///< counts from 1; 0 none
};

} // namespace pcl::sedr::sim

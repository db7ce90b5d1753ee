// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_types.h>

#include <cstdint>

namespace pcl {
namespace sedr {

/** @brief Returns a label as the value of a point's field. */
inline std::uint32_t
valueOf(StructureLabel label)
{
  return static_cast<std::uint32_t>(label);
}

} // namespace sedr
} // namespace pcl

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace pcl {
namespace sedr {

/** @brief Cosine of the angle below 90 degrees whose sine is known. */
inline double
cosineOf(double sine)
{
  return std::sqrt(1 - sine * sine);
}

} // namespace sedr
} // namespace pcl

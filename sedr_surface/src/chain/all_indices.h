// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/pcl_base.h>

#include <cstddef>
#include <numeric>

namespace pcl::sedr {

/** @brief Returns 0, 1, ..., n - 1. */
inline pcl::IndicesPtr
allIndices(std::size_t n)
{
  pcl::IndicesPtr indices(new pcl::Indices(n));
  std::iota(indices->begin(), indices->end(), 0);
  return indices;
}

} // namespace pcl::sedr

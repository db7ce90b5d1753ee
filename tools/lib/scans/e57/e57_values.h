// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "e57_packets.h"

namespace pcl::sedr::tools {

/** @brief Reads the values [first, first + size) of `field`, relative to the first one
 * in `list`, scaled, as doubles. */
void readE57Values(const E57Field& field,
                   const E57Bytes& list,
                   std::size_t first,
                   std::size_t size,
                   double* values);

} // namespace pcl::sedr::tools

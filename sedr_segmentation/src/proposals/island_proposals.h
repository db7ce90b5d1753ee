// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "face_lines.h"
#include "face_places.h"

#include <vector>

namespace pcl::sedr {

/** @brief Proposes columns: the circle and the four sides of the rectangle about each
 * island, places that hang together and with no others. O(n log n). */
std::vector<FaceCurve> proposeIslands(const FacePlaces& places);

} // namespace pcl::sedr

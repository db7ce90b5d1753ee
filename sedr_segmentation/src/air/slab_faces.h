// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "air_gaps.h"

#include <vector>

namespace pcl::sedr {

/** @brief The gaps of a scan, those parted by a single surface moved apart to the faces
 * of a slab. A slab has two faces: where only the ceiling below it was seen, because
 * furniture hid the floor, the air above would reach down to that ceiling. Slabs are
 * measured from the ceiling beside ribs and beams. Such places are taken region by
 * region. The face that was seen is the one that goes on along the region's rim; the
 * other is taken from there, and not seen. A region without a slab of two faces at its
 * rim stays as it is. O(gaps).
 * @return all gaps, in their order */
std::vector<AirGap> withBothFaces(const AirGaps& air);

} // namespace pcl::sedr

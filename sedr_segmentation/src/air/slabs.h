// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "air_gaps.h"

#include <vector>

namespace pcl::sedr {

// A slab has two faces. Where the air of two storeys is known in a column and not both
// faces were seen, those that are missing are taken from the slabs around, and not
// seen.

/** @brief The gaps of a scan with those parted that reach through a hole in what was
 * seen of a slab, with headroom on both sides. A hole larger than
 * AirParameters::largest_hole is a void or a stairwell and stays open. O(gaps) for each
 * storey.
 * @return all gaps, not sorted */
std::vector<AirGap> withHolesClosed(const AirGaps& air);

/** @brief The gaps of a scan, those parted by a single surface moved apart to the faces
 * of a slab: where only the ceiling below it was seen, because furniture hid the floor,
 * the air above would reach down to that ceiling. Such places are taken region by
 * region: the face that was seen is the one that goes on along the region's rim;
 * without a rim it is a ceiling if ceilings elsewhere are as high, else the region is a
 * gallery. The other face lies as high as most do above or below such a one. A region
 * without any stays as it is. O(gaps).
 * @param air linked
 * @return all gaps, in their order */
std::vector<AirGap> withBothFaces(const AirGaps& air);

} // namespace pcl::sedr

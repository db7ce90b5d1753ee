// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/straightening.h>

#include <vector>

namespace pcl {
namespace sedr {

/** @brief The wall faces of a scan that lean, by 5 to 28 degrees, and the vertical ones
 * beside them; none where no wall leans.
 *
 * Patches of 0.4 m that are planes and hang together in one plane are a face where they
 * cover 1.5 m2 and 1.5 m of height, and begin within 1 m of the floor before them: what
 * begins higher is the slope of a roof. Each is fitted to its points.
 * @param points thinned, level
 * @param threads 0: as many as there are processors; any number gives the same
 *
 * O(n log n). */
std::vector<LeaningFace> leaningFaces(const PointView& points,
                                      const std::vector<int>& indices,
                                      unsigned threads = 1);

} // namespace sedr
} // namespace pcl

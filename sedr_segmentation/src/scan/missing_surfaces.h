// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief What a scan lacks for a model of rooms. */
struct MissingSurfaces {
  double scatter = 0; ///< of half of the points about planes of 0.3 m at least, metres
  bool is_noisy = false; ///< it is twice the noise of slabs: the points are strewn
  std::string reason;    ///< a sentence; empty if there is a floor below a ceiling
};

/** @brief Returns whether thinned points lie on surfaces, and whether they show a floor
 * and a ceiling: level surfaces at least a quarter as large as the largest one, with a
 * headroom between them. One that stands alone is a floor if more of the upright
 * surfaces lie above it than below. O(n log n). */
MissingSurfaces missingSurfaces(const PointView& points,
                                const std::vector<int>& indices,
                                unsigned threads,
                                const Priors& priors = {});

} // namespace pcl::sedr

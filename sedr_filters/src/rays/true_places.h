// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "panes.h"

#include <pcl/sedr_filters/scan_frame.h>

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief Rays, and what each goes through first. */
struct PaneRays {
  std::vector<ScanRay> rays;
  std::vector<Pane> panes;
  std::vector<std::size_t> before; ///< pane of each ray, panes.size() for none
};

/** @brief Places that a file tells but that its points were not taken from, such as the
 * one pose of a file of several scans that were joined: those on a surface, and those
 * of which more than a tenth of the rays go through flat surfaces in a way that no pane
 * allows. A pane returns some of the rays in its direction, and there are no more than
 * in others; of what is seen through a wall from where no scanner stood, there is more
 * than a scanner casts, or nothing of the wall, or most.
 *
 * A wrong place whose rays go through nothing is not found, and does no harm.
 * @param rows every `step`-th point of the scan, those that are not finite too
 * @return places of `positions`, each once */
std::vector<Eigen::Vector3f> untruePlaces(const PiercedSurfaces& surfaces,
                                          const PaneRays& through,
                                          const PointView& rows,
                                          std::size_t step,
                                          const ScanPositions& positions,
                                          unsigned threads);

} // namespace pcl::sedr

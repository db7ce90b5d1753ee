// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pierced_surfaces.h"

#include <pcl/sedr_filters/scan_frame.h>

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief Places that a file tells but that its points were not taken from, such as the
 * one pose of a file of several scans that were joined: more than a fiftieth of the
 * rays from there go through flat surfaces in a way that no pane allows. A pane returns
 * some of the rays in its direction, and there are no more than in others; of what is
 * seen through a wall from where no scanner stood, there is more than a scanner casts,
 * or nothing of the wall, or most.
 *
 * A wrong place whose rays go through nothing is not found, and does no harm.
 * O(n) for n rows, and for some hundred rays of each place their length.
 * @param rays of raysOf()
 * @param rows every `step`-th point of the scan, those that are not finite too
 * @return places of `positions`, each once */
std::vector<Eigen::Vector3f> untruePlaces(const PiercedSurfaces& surfaces,
                                          const std::vector<ScanRay>& rays,
                                          const PointView& rows,
                                          std::size_t step,
                                          const ScanPositions& positions,
                                          unsigned threads);

} // namespace pcl::sedr

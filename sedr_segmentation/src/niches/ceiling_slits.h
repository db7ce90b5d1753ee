// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief Removes from a plan the furniture that a slit separates from the ceiling:
 * wardrobes at walls or in corners, and cabinets and tanks taken for columns.
 *
 * The ceiling above furniture that ends 5 cm below it is hidden, and voxel means do not
 * resolve the slit. The raw scan does: a wall has the same point density up to the
 * noise of the ceiling, furniture hardly any points within 4.5 cm of the ceiling. The
 * ceiling's noise is measured in front of each face. The plan stays if the noise fills
 * the slit or a face has too few points. It also stays if one face reaches the ceiling,
 * or if so few points are expected in the slit that none may be chance. Collinear walls
 * are joined again; walls around a corner are intersected.
 *
 * O(n) for n points if there are candidates; over a million, every k-th is used.
 * @param raw the scan, not thinned
 * @param indices the points to use; empty: all
 * @param threads 0: all processors
 * @return the number of removed objects */
std::size_t leaveOutBelowSlits(Floorplan& plan,
                               const PointView& raw,
                               const std::vector<int>& indices = {},
                               unsigned threads = 0,
                               const Priors& priors = {});

} // namespace pcl::sedr

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Takes out of a plan what a slit parts from the ceiling: wardrobes that the
 * outline of a room goes around, before a wall or in a corner, and cabinets and tanks
 * taken for columns.
 *
 * Over what ends 5 cm below the ceiling nothing of it is seen, and the means of voxels
 * do not tell the slit. The scan does: a wall has as many points in every centimetre up
 * to where the noise of the ceiling begins, furniture has hardly any from 4.5 cm below
 * the ceiling on. How far the ceiling's noise reaches down is measured before the face
 * in question; where it leaves nothing of the slit, or the face has too few points, the
 * plan stays. So it does where one face goes up to the ceiling, and where so few of a
 * face's points are expected in the slit that none may be by chance. Walls in line are
 * joined again, those around a corner meet in it.
 *
 * O(n) for n points if there is anything to ask of, and a pass over few of them; of
 * more than a million, every k-th is taken.
 * @param raw the scan, not thinned
 * @param indices those of its points that count; empty: all
 * @param threads 0: as many as there are processors
 * @return how many were taken out */
std::size_t leaveOutBelowSlits(Floorplan& plan,
                               const PointView& raw,
                               const std::vector<int>& indices = {},
                               unsigned threads = 0,
                               const Priors& priors = {});

} // namespace sedr
} // namespace pcl

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief Removes from a plan the niches whose back is a window pane.
 *
 * A pane reflects a few rays. Near the scanner they fill the voxels of the pane like
 * those of a wall. With nothing in range behind it, the pane looks like the back of a
 * niche. In the raw scan, the back of a niche has the point density of the wall around
 * its mouth, except for parts hidden by its sides. A niche stays if the densest quarter
 * of its back has two fifths of the density of the wall within 0.3 m of the mouth. It
 * also stays if too little of that wall was seen or it is deeper than half its mouth.
 *
 * O(n) for n points if there are niches; of more than two million, every k-th is used.
 * @param raw the scan, not thinned
 * @param indices the points to use; empty: all
 * @return the number of removed niches */
std::size_t leaveOutPanes(Floorplan& plan,
                          const PointView& raw,
                          const std::vector<int>& indices = {},
                          const Priors& priors = {});

} // namespace pcl::sedr

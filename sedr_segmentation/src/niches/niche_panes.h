// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Takes niches out of a plan whose back is the pane of a window.
 *
 * A pane sends a few of the rays back that it lets through. Where the scanner stood
 * near it for long these fill the voxels of the pane, as those of a wall are filled,
 * and where nothing is within reach behind it, it looks like the back of a niche. The
 * scan tells: the back of a niche is hit as often as the wall around its mouth, but for
 * what its sides hide. So a niche stays if the quarter of its back that most points are
 * on has two fifths of their density on the wall within 0.3 m of the mouth, where too
 * little of that wall was seen, and if it is deeper than half of its mouth.
 *
 * O(n) for n points if there are niches; of more than two million, every k-th is taken.
 * The same for any number of threads.
 * @param raw the scan, not thinned
 * @param indices those of its points that count; empty: all
 * @param threads 0: as many as there are processors
 * @return how many were taken out */
std::size_t leaveOutPanes(Floorplan& plan,
                          const PointView& raw,
                          const std::vector<int>& indices = {},
                          unsigned threads = 0,
                          const Priors& priors = {});

} // namespace sedr
} // namespace pcl

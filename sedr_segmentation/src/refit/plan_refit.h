// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Of a scan of `points`, every which is taken so that no more than `most` are:
 * 1 for all, at least. What is left needs no further thinning. */
inline std::size_t
rawStep(std::size_t points, std::size_t most)
{
  return most > 0 && points > most ? (points + most - 1) / most : 1;
}

/** @brief How a plan is fitted to the scan it came from. */
struct RefitParameters {
  Priors priors;
  double reach = 0.06;    ///< points farther from a surface are not its own, metres
  double farthest = 0.01; ///< a surface moves no farther than this and its noise
  std::size_t least_points = 20;     ///< of a surface that is fitted
  std::size_t most_points = 5000000; ///< of a larger scan, every k-th point is taken
  unsigned threads = 0;              ///< 0: as many as there are processors
};

/** @brief What became of a plan. */
struct RefitReport {
  std::size_t curves = 0; ///< lines and circles that were fitted to the scan
  std::size_t slabs = 0;
  std::string problem; ///< why nothing was fitted, a sentence; empty otherwise
};

/** @brief The last fit: every line, circle and slab of a plan to the points of the raw
 * scan near it.
 *
 * A plan is found on the means of voxels, each of which counts the same whether a
 * thousand points are behind it or one, and of which those on a small column are
 * biased. Here, each surface takes the points of the scan within `reach` of it, of
 * walls in the upper half (of narrow ones at all heights) and away from the ceiling,
 * away from corners and other surfaces; finds where most of them are and how far they
 * scatter there; and is fitted to those by robust least squares (Tukey's biweight),
 * which leaves furniture before it out. Corners are where the moved curves meet; smooth
 * joints stay so, and nearly smooth ones that the scan does not contradict become so.
 * What would move farther than its noise explains, or break a loop, stays.
 *
 * Where the other face of a partition is near, points between the faces are left to it.
 *
 * O(n) for n points, in a pass over all or every k-th and four over those near a
 * surface; the same for any number of threads. It notes which points show what, 16
 * bytes for each surface that one may show, up to some 160 MiB for 5 million points. A
 * plan with an empty loop, or one larger than a table of its cells may be, stays as it
 * is, and the report says why.
 * @param raw the scan; points that are not finite are left out
 * @param indices those of its points that count; empty: all */
RefitReport refitToRaw(Floorplan& plan,
                       const PointView& raw,
                       const std::vector<int>& indices = {},
                       const RefitParameters& parameters = {});

} // namespace sedr
} // namespace pcl

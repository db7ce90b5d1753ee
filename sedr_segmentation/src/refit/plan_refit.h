// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the step k, at least 1, such that every k-th of `points` gives at
 * most `most` points. The selection needs no further thinning. */
inline std::size_t
rawStep(std::size_t points, std::size_t most)
{
  return most > 0 && points > most ? (points + most - 1) / most : 1;
}

/** @brief Parameters of the fit of a plan to its raw scan. */
struct RefitParameters {
  Priors priors;
  double reach = 0.06;         ///< maximum distance of a surface's points, metres
  double farthest = 0.01;      ///< maximum move of a surface beyond its noise, metres
  std::size_t min_points = 20; ///< minimum number of points of a fitted surface
  std::size_t max_points = 5000000; ///< of a larger scan, every k-th point is used
  unsigned threads = 0;             ///< 0: all processors
};

/** @brief Result of refitToRaw(). */
struct RefitReport {
  std::size_t curves = 0; ///< number of fitted lines and circles
  std::size_t slabs = 0;
  std::string problem; ///< reason why nothing was fitted, a sentence; else empty
};

/** @brief Fits every line, circle and slab of a plan to nearby points of the raw scan.
 *
 * A plan is found on voxel means, which weigh one point like a thousand and are biased
 * on small columns. The refit uses the points within `reach` of each surface, away from
 * corners, the ceiling and other surfaces, and without those on what stands square to a
 * wall, such as the jambs and lintels of its openings. Walls use their upper half,
 * narrow ones all heights. The mode and scatter of these points are found, then the
 * surface is fitted by robust least squares (Tukey's biweight), which excludes
 * furniture. Corners are the intersections of the moved curves. Smooth joints stay
 * smooth, and nearly smooth ones become smooth unless the scan contradicts. Surfaces
 * that would move more than their noise explains, or break a loop, are not changed.
 *
 * Between two faces of a partition, each uses only the points on its own side.
 *
 * O(n) for n points: one pass over all or every k-th point, and some ten over those
 * near a surface. The result does not depend on the number of threads. Memory is 16
 * bytes per point and nearby surface, up to some 160 MiB for 5 million points, and as
 * much again for the points of the curves that are looked at, one a thread. A plan with
 * an empty loop, or too large for a table of its cells, is not changed, and the report
 * gives the reason.
 * @param raw the scan; points that are not finite are left out
 * @param indices the points to use; empty: all */
RefitReport refitToRaw(Floorplan& plan,
                       const PointView& raw,
                       const std::vector<int>& indices = {},
                       const RefitParameters& parameters = {});

} // namespace pcl::sedr

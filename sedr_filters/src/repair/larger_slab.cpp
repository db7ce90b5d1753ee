// SPDX-License-Identifier: BSD-3-Clause
#include "../base/plane_fit.h"

#include <pcl/sedr_filters/cell_grid.h>

#include <Eigen/Geometry>

#include <cmath>
#include <utility>
#include <vector>

namespace pcl::sedr {

namespace {

/** @brief Returns the points inside a band around a slab, or those outside. */
Positions
inBand(const Positions& points, const PlanSlab& slab, double band, bool is_inside)
{
  Positions chosen;
  for (const auto& p : points)
    if ((std::abs(distanceAbove(slab, p)) <= band) == is_inside)
      chosen.push_back(p);
  return chosen;
}

/** @brief Returns the 10 cm cells in plan that hold points. */
CellSet
placesOf(const Positions& points)
{
  const CellGrid grid(0.1);
  std::vector<CellKey> keys;
  for (const auto& p : points)
    if (grid.holds(p.x(), p.y()))
      keys.push_back(keyOf(grid.at(p.x(), p.y())));
  return CellSet(std::move(keys));
}

/** @brief Checks that the second points share few places with the first. Noise of one
 * surface would lie above and below the same places. */
bool
areSideBySide(const Positions& first, const Positions& second)
{
  const CellSet places = placesOf(second);
  return 5 * intersect(placesOf(first), places).size() <= places.size();
}

} // namespace

PlanSlab
findLargerSlab(const Positions& points,
               double tolerance,
               double maximum_tilt,
               std::uint64_t seed,
               unsigned threads)
{
  constexpr double min_spread = 0.15;  // residual across a step / tolerance
  constexpr double min_contrast = 2.5; // this residual / that of one surface
  constexpr double max_turned = 0.01;  // radians, between the two surfaces
  const PlanSlab wide = findSlab(points, tolerance, maximum_tilt, seed, threads);
  if (wide.residual < min_spread * tolerance)
    return wide;
  const double thickness = tolerance / 3;
  const auto findThin = [&](const Positions& among) {
    // A tilted plane would come near both surfaces within half of the thickness.
    const PlanSlab found = findSlab(among, thickness / 2, maximum_tilt, seed, threads);
    const PlanSlab refined = fitSlabRobustly(among, found, thickness);
    return refined.plane[2] >= std::cos(maximum_tilt) ? refined : found;
  };
  const auto isThin = [&](const PlanSlab& slab) {
    return min_contrast * slab.residual <= wide.residual;
  };
  const PlanSlab larger = findThin(points);
  const Positions rest = inBand(points, larger, thickness, false);
  if (!isThin(larger) || rest.size() < 3)
    return wide;
  const PlanSlab smaller = findThin(rest);
  const bool are_parallel =
      larger.plane.head<3>().cross(smaller.plane.head<3>()).norm() <= max_turned;
  const bool are_all = 10 * (larger.inliers + smaller.inliers) >= 9 * wide.inliers;
  return isThin(smaller) && are_parallel && are_all &&
                 areSideBySide(inBand(points, larger, thickness, true),
                               inBand(rest, smaller, thickness, true))
             ? larger
             : wide;
}

} // namespace pcl::sedr

// SPDX-License-Identifier: BSD-3-Clause
#include "wall_recess.h"

#include "sedr_filters/src/base/quantiles.h"
#include "sedr_filters/src/grids/cell_count.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::sedr {

namespace {

Cell
cellOf(const CellGrid& grid, const WallPoint& p)
{
  return grid.at(p.along, p.up);
}

/** @brief Returns the depth with the most points behind a region. */
double
depthOfBack(const std::vector<WallPoint>& region, double tolerance)
{
  std::vector<double> depths;
  for (const WallPoint& p : region)
    if (p.behind > tolerance)
      depths.push_back(p.behind);
  if (depths.empty())
    return 0;
  std::sort(depths.begin(), depths.end());
  const auto [first, last] = densestWindow(depths, 2 * tolerance);
  return depths[(first + last) / 2];
}

/** @brief Moves the edges of a recess onto the points of its sides. */
void
fitEdges(const UnrolledWall& wall, const Priors& priors, Recess& recess)
{
  const double reach = priors.surface_band;
  const auto fit = [&](double& edge, double WallPoint::*across,
                       double WallPoint::*beside, double low, double high) {
    std::vector<double> places;
    for (const WallPoint& p : wall.points)
      if (std::abs(p.*across - edge) <= reach && p.*beside > low + reach &&
          p.*beside < high - reach && p.behind > wall.tolerance &&
          p.behind < recess.depth - wall.tolerance)
        places.push_back(p.*across);
    if (places.size() < 5)
      return false;
    edge = middleValue(std::move(places));
    return true;
  };
  fit(recess.left, &WallPoint::along, &WallPoint::up, recess.low, recess.high);
  fit(recess.right, &WallPoint::along, &WallPoint::up, recess.low, recess.high);
  recess.has_bottom =
      fit(recess.low, &WallPoint::up, &WallPoint::along, recess.left, recess.right) &&
      recess.low >= priors.wall_band; // a lower bottom is the floor
  fit(recess.high, &WallPoint::up, &WallPoint::along, recess.left, recess.right);
  std::vector<double> depths;
  for (const WallPoint& p : wall.points)
    if (p.along > recess.left + wall.tolerance &&
        p.along < recess.right - wall.tolerance && p.up > recess.low + wall.tolerance &&
        p.up < recess.high - wall.tolerance &&
        std::abs(p.behind - recess.depth) <= wall.tolerance)
      depths.push_back(p.behind);
  if (!depths.empty())
    recess.depth = middleValue(std::move(depths));
}

/** @brief Returns whether the back of a region is closed and no points lie beyond it or
 * its sides. The reveal of a window continues behind the pane. */
bool
isClosed(const CellMask& region,
         const std::vector<WallPoint>& behind,
         const CellGrid& grid,
         double depth,
         double tolerance,
         const NicheParameters& parameters)
{
  const CellMask inside = eroded(region, 1);
  const CellMask rim = subtract(dilated(region, 1), inside);
  CellMask back(region.box());
  CellMask beyond(region.box());
  for (const WallPoint& p : behind) {
    const Cell cell = cellOf(grid, p);
    if (std::abs(p.behind - depth) <= 1.5 * tolerance)
      back.set(cell, 1);
    else if (p.behind > depth)
      beyond.set(cell, 1);
  }
  const auto share = [](const CellMask& seen, const CellMask& of) {
    return static_cast<double>(intersect(seen, of).count()) /
           static_cast<double>(std::max<std::size_t>(1, of.count()));
  };
  const Priors& priors = parameters.priors;
  const double greatest_view = priors.share_little / 2;
  return share(back, inside) >= priors.share_closed &&
         share(beyond, inside) <= greatest_view && share(beyond, rim) <= greatest_view;
}

} // namespace

CellMask
openCells(const UnrolledWall& wall, const CellGrid& grid)
{
  const CellBox box{{-2, -3},
                    {cellsFor(wall.element.length(), grid.size()) + 2,
                     cellsFor(wall.height, grid.size()) + 2}};
  CellMask on(box);
  CellMask behind(box);
  for (const WallPoint& p : wall.points)
    (p.behind <= wall.tolerance ? on : behind).set(cellOf(grid, p), 1);
  const CellMask open = subtract(behind, on);
  return eroded(dilated(open, 1), 1);
}

bool
findRecess(const UnrolledWall& wall,
           const CellMask& region,
           const CellGrid& grid,
           const NicheParameters& parameters,
           Recess& recess)
{
  const CellMask around = dilated(region, 1);
  std::vector<WallPoint> behind;
  for (const WallPoint& p : wall.points)
    if (around.at(cellOf(grid, p)))
      behind.push_back(p);
  recess.depth = depthOfBack(behind, wall.tolerance);
  const Priors& priors = parameters.priors;
  if (recess.depth < priors.min_niche_depth || recess.depth > priors.max_niche_depth ||
      !isClosed(region, behind, grid, recess.depth, wall.tolerance, parameters))
    return false;
  const CellBox box = boxOf(region.toSet());
  const double size = grid.size();
  recess.left = box.low.x * size;
  recess.right = (box.high.x + 1) * size;
  recess.low = box.low.y * size;
  recess.high = (box.high.y + 1) * size;
  const double area = (recess.right - recess.left) * (recess.high - recess.low);
  if (static_cast<double>(region.count()) * size * size < priors.share_closed * area)
    return false;
  fitEdges(wall, priors, recess);
  if (recess.high > wall.height - priors.wall_band)
    recess.high = wall.height;
  return recess.right - recess.left >= priors.min_recess &&
         recess.high - recess.low >= priors.min_recess;
}

} // namespace pcl::sedr

// SPDX-License-Identifier: BSD-3-Clause
#include "../surface/cell_points.h"
#include "../surface/riser_bins.h"
#include "shape_proposals.h"

#include "sedr_filters/src/base/quantiles.h"
#include "sheet_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr std::size_t max_a_cell = 40; ///< points: near a scanner there are thousands

ShapeKind
kindOf(const PlanSlab& slab)
{
  if (!slab.curve)
    return slab.plane.head<2>().isZero(0) ? ShapeKind::Level : ShapeKind::Plane;
  if (slab.curve->kind == CurveKind::Cylinder)
    return slab.curve->isRound() ? ShapeKind::Cylinder : ShapeKind::EllipticCylinder;
  return slab.curve->isSphere() ? ShapeKind::Sphere : ShapeKind::Ellipsoid;
}

/** @brief The standard deviation of most points about a facet. */
double
noiseAbout(const PlanSlab& facet, const std::vector<Eigen::Vector3d>& points)
{
  constexpr double of_median = 1.4826;
  std::vector<double> off;
  for (const Eigen::Vector3d& p : points)
    off.push_back(std::abs(distanceOf(facet, p)));
  return of_median * middleValue(std::move(off));
}

/** @brief The cells that lie within their facet, away from the walls. */
std::vector<std::uint8_t>
cellsWithinFacets(const FacetSheet& sheet)
{
  const SheetGrid& grid = sheet.grid;
  std::vector<std::uint8_t> is_within(grid.count(), 0);
  for (std::size_t cell = 0; cell < grid.count(); ++cell) {
    bool is_alike = true;
    // Beside the room is a wall, whose points are near a facet, too.
    const bool is_off_rim = grid.forAllWithin(cell, 1, [&](std::size_t near) {
      is_alike = is_alike && sheet.is_inside[near] != 0 &&
                 sheet.label[near] == sheet.label[cell];
    });
    is_within[cell] = is_alike && is_off_rim ? 1 : 0;
  }
  return is_within;
}

/** @brief Calls `use(cell, point)` for the points near the facet of their cell. */
template <typename Use>
void
forAllNear(const FacetSheet& sheet,
           const std::vector<std::uint8_t>& is_within,
           const PointView& scan,
           const std::vector<int>& indices,
           Use use)
{
  const double band = std::max(RiserBins::margin, 5 * sheet.noise);
  forAllOver(sheet.grid, scan, indices,
             [&](std::size_t cell, const Eigen::Vector3d& p) {
               if (!is_within[cell])
                 return;
               const PlanSlab& facet =
                   sheet.facets[static_cast<std::size_t>(sheet.label[cell])];
               if (std::abs(distanceOf(facet, p)) < band)
                 use(cell, p);
             });
}

} // namespace

void
refitToScan(FacetSheet& sheet,
            const PointView& scan,
            const std::vector<int>& indices,
            const SheetParameters& parameters)
{
  constexpr std::size_t min_points = 200;
  const std::vector<std::uint8_t> is_within = cellsWithinFacets(sheet);
  std::vector<std::uint32_t> count(sheet.grid.count(), 0);
  forAllNear(sheet, is_within, scan, indices,
             [&](std::size_t cell, const Eigen::Vector3d&) { ++count[cell]; });
  std::vector<std::uint32_t> passed(sheet.grid.count(), 0);
  std::vector<std::vector<Eigen::Vector3d>> points(sheet.facets.size());
  forAllNear(sheet, is_within, scan, indices,
             [&](std::size_t cell, const Eigen::Vector3d& p) {
               if (isChosen(passed[cell]++, count[cell], max_a_cell))
                 points[static_cast<std::size_t>(sheet.label[cell])].push_back(p);
             });
  for (std::size_t f = 0; f < sheet.facets.size(); ++f) {
    PlanSlab& facet = sheet.facets[f];
    if (points[f].size() < min_points || isRelief(facet))
      continue;
    FacetProposal refined{kindOf(facet), facet, {}};
    refineShape(refined.kind, points[f],
                std::hypot(noiseAbout(facet, points[f]), parameters.unevenness),
                refined.slab);
    if (!isBuilt(refined, parameters))
      continue;
    facet = refined.slab;
    facet.residual = noiseAbout(facet, points[f]);
    facet.inliers = points[f].size();
  }
}

} // namespace pcl::sedr

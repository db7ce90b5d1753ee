// SPDX-License-Identifier: BSD-3-Clause
#include "shape_proposals.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl {
namespace sedr {

namespace {

constexpr double band = 3;                ///< deviations that a point of a facet is off
constexpr std::size_t most_points = 1500; ///< that a growing shape is fitted to

bool
explainsCell(const PlanSlab& slab,
             const CellPoints& cells,
             std::size_t cell,
             double deviation)
{
  std::ptrdiff_t near = 0;
  for (const Eigen::Vector3d* p = cells.begin(cell); p != cells.end(cell); ++p)
    near += std::abs(distanceOf(slab, *p)) < band * deviation ? 1 : 0;
  return 2 * near > cells.end(cell) - cells.begin(cell);
}

/** @brief The cells that a shape explains and that hang together with a seed, gaps of
 * two cells and narrow things before the ceiling skipped. */
std::vector<std::size_t>
grownCells(const PlanSlab& slab,
           const CellPoints& cells,
           std::size_t seed,
           double deviation)
{
  constexpr int reach = 3;
  const SheetGrid& grid = cells.grid();
  std::vector<std::uint8_t> is_known(grid.count(), 0);
  std::vector<std::size_t> grown{seed};
  is_known[seed] = 1;
  for (std::size_t k = 0; k < grown.size(); ++k) {
    const int x = grid.columnOf(grown[k]);
    const int y = grid.rowOf(grown[k]);
    for (int row = y - reach; row <= y + reach; ++row)
      for (int column = x - reach; column <= x + reach; ++column) {
        if (!grid.holds(column, row))
          continue;
        const std::size_t next = grid.indexOf(column, row);
        if (is_known[next])
          continue;
        is_known[next] = 1;
        if (!cells.isEmpty(next) && explainsCell(slab, cells, next, deviation))
          grown.push_back(next);
      }
  }
  std::sort(grown.begin(), grown.end());
  return grown;
}

bool
isCurve(ShapeKind kind)
{
  return kind != ShapeKind::Plane;
}

/** @brief Grows shapes from one window. */
class Grower {
public:
  Grower(const CellPoints& cells,
         const std::vector<double>& directions,
         double deviation,
         const SheetParameters& parameters)
      : cells_(cells)
      , directions_(directions)
      , deviation_(deviation)
      , parameters_(parameters)
  {}

  /** @return whether a shape was found, which is then the last of `found` */
  bool grow(ShapeKind kind,
            std::size_t seed,
            int reach,
            std::vector<FacetProposal>& found) const
  {
    constexpr double least_share = 0.6;
    constexpr int rounds = 3;
    const std::vector<std::size_t> window = cells_.window(seed, reach);
    // Half of it may lie beside the room.
    if (2 * window.size() < static_cast<std::size_t>((2 * reach + 1) * (2 * reach + 1)))
      return false;
    if (isCurve(kind) && isFlat(window))
      return false;
    FacetProposal facet = fitFacet(kind, cells_, window, directions_, deviation_);
    for (int round = 0; round < rounds; ++round) {
      if (!isBuilt(facet, parameters_) ||
          shareExplained(facet, cells_, window, deviation_) < least_share)
        return false;
      std::vector<std::size_t> grown = grownCells(facet.slab, cells_, seed, deviation_);
      const bool has_settled = grown == facet.cells;
      facet.cells = std::move(grown);
      if (has_settled)
        break;
      refineShape(kind, cells_.pointsOf(facet.cells, most_points), deviation_,
                  facet.slab);
    }
    found.push_back(std::move(facet));
    return true;
  }

private:
  /** @brief Whether a plane explains all of some cells. */
  bool isFlat(const std::vector<std::size_t>& window) const
  {
    const auto points = cells_.pointsOf(window, most_points);
    const PlanSlab plane = fitPlane(points);
    double sum = 0;
    for (const Eigen::Vector3d& p : points)
      sum += std::pow(distanceOf(plane, p), 2);
    return sum < deviation_ * deviation_ * static_cast<double>(points.size());
  }

  const CellPoints& cells_;
  const std::vector<double>& directions_;
  double deviation_;
  const SheetParameters& parameters_;
};

} // namespace

bool
isBuilt(const FacetProposal& facet, const SheetParameters& parameters)
{
  constexpr double least_radius = 0.3; // of a cove, metres
  if (!isCurve(facet.kind)) {
    // A rafter's slope is measured to a degree.
    const double steepest = std::cos(parameters.steepest + M_PI / 180);
    return facet.slab.plane.allFinite() && facet.slab.plane[2] >= steepest;
  }
  if (!facet.slab.curve || !facet.slab.curve->isFinite())
    return false;
  const SlabCurve& c = *facet.slab.curve;
  const auto isRadius = [&](double radius) {
    return radius >= least_radius && radius <= parameters.largest_radius;
  };
  return isRadius(c.across) && isRadius(c.up) &&
         (c.kind == CurveKind::Cylinder || isRadius(c.along));
}

double
shareExplained(const FacetProposal& facet,
               const CellPoints& cells,
               const std::vector<std::size_t>& among,
               double deviation)
{
  const auto explained =
      std::count_if(among.begin(), among.end(), [&](std::size_t cell) {
        return explainsCell(facet.slab, cells, cell, deviation);
      });
  return static_cast<double>(explained) / static_cast<double>(among.size());
}

FacetProposal
fitFacet(ShapeKind kind,
         const CellPoints& cells,
         std::vector<std::size_t> own,
         const std::vector<double>& directions,
         double deviation,
         std::size_t most_points)
{
  const auto points = cells.pointsOf(own, most_points);
  FacetProposal facet;
  facet.kind = kind;
  facet.cells = std::move(own);
  facet.slab = startShape(kind, points, directions);
  if (isCurve(kind) && !facet.slab.curve)
    return facet; // is not built
  // Wide at first: a window may hold a lamp, or reach over a crease.
  for (const double widening : {4.0, 2.0, 1.0})
    refineShape(kind, points, widening * deviation, facet.slab);
  return facet;
}

std::vector<FacetProposal>
proposeFacets(const CellPoints& cells,
              const std::vector<double>& directions,
              double deviation,
              const SheetParameters& parameters)
{
  struct Scale {
    ShapeKind kind;
    int reach; // cells
  };
  const std::vector<Scale> scales{{ShapeKind::Plane, 3},     {ShapeKind::Cylinder, 5},
                                  {ShapeKind::Cylinder, 10}, {ShapeKind::Cylinder, 16},
                                  {ShapeKind::Sphere, 10},   {ShapeKind::Sphere, 16}};
  constexpr std::size_t most_seeds = 600;
  const SheetGrid& grid = cells.grid();
  const int stride = std::max(
      4, static_cast<int>(std::sqrt(static_cast<double>(grid.count()) / most_seeds)));
  const Grower grower(cells, directions, deviation, parameters);
  std::vector<FacetProposal> found;
  for (const Scale& scale : scales) {
    std::vector<std::uint8_t> is_covered(grid.count(), 0);
    for (const FacetProposal& facet : found)
      if (facet.kind == scale.kind)
        for (const std::size_t cell : facet.cells)
          is_covered[cell] = 1;
    for (int y = stride / 2; y < grid.rows; y += stride)
      for (int x = stride / 2; x < grid.columns; x += stride) {
        const std::size_t seed = grid.indexOf(x, y);
        if (is_covered[seed] || cells.isEmpty(seed) ||
            !grower.grow(scale.kind, seed, scale.reach, found))
          continue;
        for (const std::size_t cell : found.back().cells)
          is_covered[cell] = 1;
      }
  }
  return found;
}

} // namespace sedr
} // namespace pcl

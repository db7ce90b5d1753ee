// SPDX-License-Identifier: BSD-3-Clause
#include "shape_proposals.h"

#include "../surface/cell_points.h"
#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr std::size_t few_points = 250;  ///< that a shape in a window is fitted to
constexpr std::size_t max_points = 1500; ///< that a growing shape is fitted to

bool
explainsCell(const PlanSlab& slab,
             const CellPoints& cells,
             std::size_t cell,
             double deviation)
{
  const CellBall& ball = cells.ball(cell);
  if (std::abs(distanceOf(slab, ball.centre)) >
      2 * ball.radius + facet_band * deviation)
    return false;
  // As soon as the points that are left cannot change the answer, it is given.
  const std::ptrdiff_t size = cells.end(cell) - cells.begin(cell);
  std::ptrdiff_t near = 0;
  std::ptrdiff_t off = 0;
  for (const Eigen::Vector3d* p = cells.begin(cell); 2 * near <= size && 2 * off < size;
       ++p)
    ++(std::abs(distanceOf(slab, *p)) < facet_band * deviation ? near : off);
  return 2 * near > size;
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
  for (std::size_t k = 0; k < grown.size(); ++k)
    grid.forAllWithin(grown[k], reach, [&](std::size_t next) {
      if (is_known[next])
        return;
      is_known[next] = 1;
      if (!cells.isEmpty(next) && explainsCell(slab, cells, next, deviation))
        grown.push_back(next);
    });
  std::sort(grown.begin(), grown.end());
  return grown;
}

/** @brief Whether a shape explains most cells of a window, each by half of its points.
 */
bool
explainsMost(const PlanSlab& slab,
             const FacetEvidence& evidence,
             const std::vector<std::size_t>& window)
{
  constexpr double min_share = 0.6;
  const auto count = std::count_if(window.begin(), window.end(), [&](auto cell) {
    return explainsCell(slab, evidence.cells, cell, evidence.deviation);
  });
  return static_cast<double>(count) >= min_share * static_cast<double>(window.size());
}

/** @brief Appends the shape that grows from one window, if any does. */
void
growFrom(std::size_t seed,
         ShapeKind kind,
         int reach,
         const FacetEvidence& evidence,
         std::vector<FacetProposal>& found)
{
  constexpr int rounds = 3;
  const CellPoints& cells = evidence.cells;
  const std::vector<std::size_t> window = cells.window(seed, reach);
  // Half of it may lie beside the room.
  if (2 * window.size() < static_cast<std::size_t>((2 * reach + 1) * (2 * reach + 1)))
    return;
  FacetProposal facet = fitFacet(kind, evidence, window, few_points);
  for (int round = 0; round < rounds; ++round) {
    if (!isBuilt(facet, evidence.parameters) ||
        !explainsMost(facet.slab, evidence, window))
      return;
    std::vector<std::size_t> grown =
        grownCells(facet.slab, cells, seed, evidence.deviation);
    const bool has_settled = grown == facet.cells;
    facet.cells = std::move(grown);
    if (has_settled)
      break;
    refineShape(kind, cells.pointsOf(facet.cells, max_points), evidence.deviation,
                facet.slab);
  }
  if (isBuilt(facet, evidence.parameters)) // after the last refinement, too
    found.push_back(std::move(facet));
}

/** @brief Grows shapes from windows all over the plan, but where there are some. Some
 * windows are looked at side by side: what one of them finds counts unless one before
 * it covers its seed. */
void
growFromSeeds(const FacetEvidence& evidence,
              ShapeKind kind,
              int reach,
              std::vector<FacetProposal>& found)
{
  constexpr std::size_t max_seeds = 600;
  const SheetGrid& grid = evidence.cells.grid();
  // No window's own half lies between two seeds: a beam is not much wider.
  const int stride = std::min(
      reach + 1, std::max(4, static_cast<int>(std::sqrt(
                                 static_cast<double>(grid.count()) / max_seeds))));
  std::vector<std::uint8_t> is_covered(grid.count(), 0);
  const auto cover = [&](const FacetProposal& facet) {
    for (const std::size_t cell : facet.cells)
      is_covered[cell] = 1;
  };
  std::for_each(found.begin(), found.end(), cover);
  constexpr std::size_t side_by_side = 8;
  std::vector<std::size_t> seeds;
  const auto growAll = [&] {
    std::vector<std::vector<FacetProposal>> grown(seeds.size());
    parallelBlocks(seeds.size(), 1, evidence.parameters.threads,
                   [&](std::size_t k, std::size_t) {
                     growFrom(seeds[k], kind, reach, evidence, grown[k]);
                   });
    for (std::size_t k = 0; k < seeds.size(); ++k)
      if (!is_covered[seeds[k]] && !grown[k].empty()) {
        found.push_back(std::move(grown[k].front()));
        cover(found.back());
      }
    seeds.clear();
  };
  for (int y = stride / 2; y < grid.rows; y += stride)
    for (int x = stride / 2; x < grid.columns; x += stride) {
      const std::size_t seed = grid.indexOf(x, y);
      if (is_covered[seed] || evidence.cells.isEmpty(seed))
        continue;
      seeds.push_back(seed);
      if (seeds.size() == side_by_side)
        growAll();
    }
  growAll();
}

} // namespace

bool
isBuilt(const FacetProposal& facet, const SheetParameters& parameters)
{
  constexpr double min_radius = 0.3; // of a cove, metres
  constexpr double max_rise = 1.5;   // of a vault, in half spans
  if (isFlat(facet.kind))
    return facet.slab.plane.allFinite() && facet.slab.plane[2] >= min_upward;
  if (!facet.slab.curve || !facet.slab.curve->isFinite())
    return false;
  const SlabCurve& c = *facet.slab.curve;
  const auto isRadius = [&](double radius) {
    return radius >= min_radius && radius <= parameters.largest_radius;
  };
  return isRadius(c.across) && isRadius(c.up) && c.up <= max_rise * c.across &&
         (c.kind == CurveKind::Cylinder ||
          (isRadius(c.along) && c.up <= max_rise * c.along));
}

FacetProposal
fitFacet(ShapeKind kind,
         const FacetEvidence& evidence,
         std::vector<std::size_t> own,
         std::size_t max_points)
{
  const auto points = evidence.cells.pointsOf(own, max_points);
  FacetProposal facet;
  facet.kind = kind;
  facet.cells = std::move(own);
  facet.slab = startShape(kind, points, evidence.directions);
  if (!isFlat(kind) && !facet.slab.curve)
    return facet; // is not built
  // Wide at first: a window may hold a lamp, or reach over a crease.
  constexpr double roughly = 1e-3;
  for (const double widening : {4.0, 2.0, 1.0})
    refineShape(kind, points, widening * evidence.deviation, facet.slab, roughly);
  return facet;
}

namespace {

/** @brief How far a surface that may tilt and bend lies off a plane through the same
 * cells, in the worst of them, metres. */
double
bendOf(const PlanSlab& plane,
       const std::vector<std::size_t>& own,
       const FacetEvidence& evidence)
{
  const auto points = evidence.cells.pointsOf(own, max_points);
  const Eigen::Vector3d mean = meanOf(points);
  std::vector<Eigen::Vector3d> offs; // from the plane, about the middle
  for (const Eigen::Vector3d& p : points)
    if (const double off = distanceOf(plane, p);
        std::abs(off) <= facet_band * evidence.deviation)
      offs.emplace_back(p.x() - mean.x(), p.y() - mean.y(), off);
  const QuadraticTerms bent = fitQuadratic(offs);
  double most = bent.allFinite() ? 0 : std::numeric_limits<double>::infinity();
  for (const std::size_t cell : own)
    most = std::max(most, std::abs(bent.dot(quadraticTerms(
                              evidence.cells.grid().centre(cell) - mean.head<2>()))));
  return most;
}

/** @brief The cells that a plane explains and that need no other shape: large
 * pieces that are truly flat, no strips of a vault. */
std::vector<std::size_t>
flatCells(const PlanSlab& plane, const FacetEvidence& evidence)
{
  const CellPoints& cells = evidence.cells;
  std::vector<std::uint8_t> is_own(cells.grid().count(), 0);
  for (const std::size_t cell : cells.seen())
    is_own[cell] = explainsCell(plane, cells, cell, evidence.deviation) ? 1 : 0;
  std::vector<std::size_t> flat;
  const double cell_area = cells.grid().size * cells.grid().size;
  for (const auto& piece : piecesOf(cells.grid(), is_own))
    if (static_cast<double>(piece.size()) * cell_area >=
            evidence.parameters.min_relief &&
        bendOf(plane, piece, evidence) < evidence.deviation)
      flat.insert(flat.end(), piece.begin(), piece.end());
  std::sort(flat.begin(), flat.end());
  return flat;
}

/** @brief Level planes at the peaks of the histogram of heights. Their `cells` are
 * flatCells(). */
std::vector<FacetProposal>
proposeLevels(const FacetEvidence& evidence)
{
  constexpr int most = 40;
  const CellPoints& cells = evidence.cells;
  const double cell_size = cells.grid().size;
  const auto least = static_cast<std::size_t>(
      std::ceil(evidence.parameters.min_area / (2 * cell_size * cell_size)));
  const double band = facet_band * evidence.deviation;
  std::vector<std::pair<double, std::size_t>> heights; // of flat cells
  for (const std::size_t cell : cells.seen()) {
    double sum = 0;
    for (const Eigen::Vector3d* p = cells.begin(cell); p != cells.end(cell); ++p)
      sum += p->z();
    heights.emplace_back(sum / static_cast<double>(cells.end(cell) - cells.begin(cell)),
                         cell);
  }
  std::sort(heights.begin(), heights.end());
  std::vector<FacetProposal> found;
  for (int tried = 0; tried < most; ++tried) {
    std::size_t first = 0;
    std::size_t count = 0;
    for (std::size_t low = 0, high = 0; high < heights.size(); ++high) {
      while (heights[high].first - heights[low].first > band)
        ++low;
      if (high - low + 1 > count) {
        first = low;
        count = high - low + 1;
      }
    }
    if (count < std::max<std::size_t>(least, 1))
      break;
    std::vector<std::size_t> own;
    for (std::size_t k = first; k < first + count; ++k)
      own.push_back(heights[k].second);
    heights.erase(heights.begin() + static_cast<std::ptrdiff_t>(first),
                  heights.begin() + static_cast<std::ptrdiff_t>(first + count));
    std::sort(own.begin(), own.end());
    FacetProposal level = fitFacet(ShapeKind::Level, evidence, std::move(own));
    level.cells = flatCells(level.slab, evidence);
    const double height = level.slab.heightAt(Eigen::Vector2d::Zero());
    heights.erase(std::remove_if(heights.begin(), heights.end(),
                                 [&](const auto& other) {
                                   return std::abs(other.first - height) < band / 2 ||
                                          explainsCell(level.slab, cells, other.second,
                                                       evidence.deviation);
                                 }),
                  heights.end());
    found.push_back(std::move(level));
  }
  return found;
}

} // namespace

std::vector<FacetProposal>
proposeFacets(const FacetEvidence& evidence)
{
  std::vector<FacetProposal> all = proposeLevels(evidence);
  for (const int reach : {3, 1}) // cells
    growFromSeeds(evidence, ShapeKind::Plane, reach, all);
  std::vector<FacetProposal> flat = all; // other shapes are looked for elsewhere
  for (FacetProposal& plane : flat)
    if (plane.kind == ShapeKind::Plane)
      plane.cells = flatCells(plane.slab, evidence);
  if (evidence.parameters.is_floor)
    return all;
  constexpr ShapeKind curves[] = {ShapeKind::Cylinder, ShapeKind::Sphere};
  std::vector<std::vector<FacetProposal>> found(std::size(curves), flat);
  parallelBlocks(found.size(), 1, evidence.parameters.threads,
                 [&](std::size_t k, std::size_t) {
                   // A window with a curve in it is mostly of that curve: the smallest
                   // dome that is tested is 1.7 m wide, in cells of 10 and 15 cm.
                   for (const int reach : {5, 10, 16})
                     growFromSeeds(evidence, curves[k], reach, found[k]);
                 });
  for (auto& of_kind : found)
    std::move(of_kind.begin() + static_cast<std::ptrdiff_t>(flat.size()), of_kind.end(),
              std::back_inserter(all));
  return all;
}

} // namespace pcl::sedr

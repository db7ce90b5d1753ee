// SPDX-License-Identifier: BSD-3-Clause
#include "sheet_fit.h"

#include "../surface/cell_points.h"
#include "facet_choice.h"
#include "floor_pieces.h"
#include "shape_proposals.h"

#include "sedr_filters/src/base/quantiles.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr double coarsest_cell = 0.15; ///< metres: in larger ones much is beside a step

/** @brief Gives a sheet its facets, and to curves the planes that stand for them. */
void
takeFacets(const CellPoints& cells, FacetChoice choice, FacetSheet& sheet)
{
  constexpr std::size_t max_points = 5000;
  std::vector<std::vector<std::size_t>> own(choice.facets.size());
  for (const std::size_t cell : cells.seen())
    own[static_cast<std::size_t>(sheet.label[cell])].push_back(cell);
  for (std::size_t k = 0; k < choice.facets.size(); ++k) {
    PlanSlab& slab = choice.facets[k].slab;
    const auto points = cells.pointsOf(own[k], max_points);
    slab.inliers = points.size();
    slab.residual = sheet.noise;
    if (slab.curve && !points.empty()) {
      slab.plane = fitPlane(points).plane;
      if (!(slab.plane[2] >= min_upward))
        slab.plane = planeThrough(meanOf(points), Eigen::Vector2d::Zero()).plane;
    }
    sheet.facets.push_back(std::move(slab));
  }
}

} // namespace

double
FacetSheet::heightAt(const Eigen::Vector2d& p) const
{
  // Beside the grid facets are not known: a slope would go on below the floor.
  const Eigen::Vector2d place =
      grid.cellsTo(p).cwiseMax(0).cwiseMin(Eigen::Vector2d(grid.columns, grid.rows));
  return facets[static_cast<std::size_t>(label[grid.nearest(p)])].heightAt(
      grid.placeOf(place.x(), place.y()));
}

std::vector<Eigen::Vector3d>
placesOf(const PointView& points, const std::vector<int>& indices)
{
  std::vector<Eigen::Vector3d> places;
  places.reserve(indices.size());
  for (const int i : indices)
    if (points.isFinite(static_cast<std::size_t>(i)))
      places.emplace_back(points[static_cast<std::size_t>(i)].cast<double>());
  return places;
}

FacetSheet
fitSheet(const std::vector<Eigen::Vector3d>& points,
         const SheetGrid& grid,
         const std::vector<std::uint8_t>& domain,
         const std::vector<double>& directions,
         const SheetParameters& parameters,
         const std::vector<Eigen::Vector3d>& around,
         const FurnishedFloor* floor)
{
  constexpr std::size_t min_points = 50;
  constexpr std::size_t max_a_cell = 5; // the last fit is to all
  FacetSheet sheet;
  sheet.grid = grid;
  sheet.is_inside = domain;
  const CellPoints cells(sheet.grid, sheet.is_inside, points, max_a_cell);
  if (cells.size() < min_points)
    return sheet;
  sheet.noise = cells.noise();
  const double deviation = std::hypot(sheet.noise, parameters.unevenness);
  std::optional<RiserBins> risers;
  if (!around.empty() && grid.size <= coarsest_cell)
    risers.emplace(grid, domain, around, cells.lowest(), cells.highest());
  const FacetEvidence evidence{cells, directions, deviation, parameters,
                               risers ? &*risers : nullptr};
  FacetChoice choice = chooseFacets(evidence, proposeFacets(evidence));
  if (choice.facets.empty())
    return sheet;
  for (std::size_t cell = 0; cell < choice.label.size(); ++cell)
    if (!domain[cell])
      choice.label[cell] = FacetSheet::none;
  dropPieces(evidence, choice);
  if (floor) {
    dropFurniture(evidence, around, *floor, choice);
    for (std::size_t cell = 0; cell < choice.label.size(); ++cell)
      if (choice.label[cell] == FacetSheet::none)
        sheet.is_inside[cell] = 0;
  }
  choice.sortBySize();
  if (choice.facets.empty())
    return sheet;
  fillNearest(grid, choice.label);
  if (!parameters.is_floor)
    extendBeams(evidence, choice);
  for (std::size_t cell = 0; cell < choice.label.size(); ++cell)
    if (!domain[cell])
      choice.label[cell] = FacetSheet::none;
  choice.sortBySize();
  fillNearest(grid, choice.label);
  sheet.label = choice.label;
  for (std::size_t cell = 0; cell < grid.count(); ++cell)
    sheet.is_seen.push_back(choice.explains(cell, evidence) ? 1 : 0);
  takeFacets(cells, std::move(choice), sheet);
  return sheet;
}

FacetSheet
surfaceWithin(const PlanLoop& loop,
              const std::vector<Eigen::Vector3d>& points,
              const SheetParameters& parameters,
              const std::vector<Eigen::Vector3d>& around)
{
  const SheetGrid grid = gridWithin(loop, parameters);
  return fitSheet(points, grid, cellsWithin(grid, loop), wallDirections(loop),
                  parameters, around);
}

bool
hasSlope(const FacetSheet& sheet)
{
  return std::any_of(
      sheet.facets.begin(), sheet.facets.end(),
      [](const PlanSlab& facet) { return !isRelief(facet) && !isLevel(facet); });
}

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

namespace {

/** @brief Gives a slab heights over a box, `spacing` metres apart. */
template <typename HeightAt>
PlanSlab
reliefOver(const Eigen::AlignedBox2d& box,
           double spacing,
           PlanSlab slab,
           HeightAt heightAt)
{
  SlabCurve relief;
  relief.kind = CurveKind::Relief;
  relief.spacing = spacing;
  relief.centre = box.min();
  const Eigen::Vector2d extent = box.sizes() / spacing;
  relief.columns = static_cast<std::size_t>(std::ceil(extent.x())) + 1;
  const auto rows = static_cast<std::size_t>(std::ceil(extent.y())) + 1;
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < relief.columns; ++column)
      relief.heights.push_back(heightAt(
          relief.centre + spacing * Eigen::Vector2d(static_cast<double>(column),
                                                    static_cast<double>(row))));
  slab.curve = std::make_shared<const SlabCurve>(std::move(relief));
  return slab;
}

/** @brief The heights of some cells with points: at each place that of a plane through
 * the points about the nearest cell, without outliers. */
PlanSlab
reliefOf(const FacetEvidence& evidence, const std::vector<std::size_t>& own)
{
  const CellPoints& cells = evidence.cells;
  const SheetGrid& grid = cells.grid();
  const double spacing = evidence.parameters.relief_spacing;
  std::vector<std::int32_t> nearest(grid.count(), FacetSheet::none);
  Eigen::AlignedBox2d box;
  for (const std::size_t cell : own) {
    nearest[cell] = static_cast<std::int32_t>(cell);
    for (const double off : {-spacing, spacing})
      box.extend(grid.centre(cell) + Eigen::Vector2d::Constant(off));
  }
  fillNearest(grid, nearest);
  const int reach = std::max(1, static_cast<int>(spacing / grid.size));
  const auto heightAt = [&](const Eigen::Vector2d& place) {
    const auto middle = static_cast<std::size_t>(nearest[grid.nearest(place)]);
    std::vector<std::size_t> near = cells.window(middle, reach);
    near.erase(std::remove_if(near.begin(), near.end(),
                              [&](std::size_t cell) {
                                return nearest[cell] != static_cast<std::int32_t>(cell);
                              }),
               near.end());
    const auto points = cells.pointsOf(near, cells.size());
    PlanSlab plane = fitPlane(points);
    refineShape(ShapeKind::Plane, points, evidence.deviation, plane);
    const auto [low, high] =
        std::minmax_element(points.begin(), points.end(),
                            [](const auto& a, const auto& b) { return a.z() < b.z(); });
    return std::clamp(plane.heightAt(place), low->z(), high->z());
  };
  return reliefOver(box, spacing, fitPlane(cells.pointsOf(own, cells.size())),
                    heightAt);
}

} // namespace

PlanSlab
reliefOf(const FacetSheet& sheet, double spacing)
{
  Eigen::AlignedBox2d box;
  for (const int x : {0, sheet.grid.columns})
    for (const int y : {0, sheet.grid.rows})
      box.extend(sheet.grid.placeOf(x, y));
  return reliefOver(box, spacing, sheet.facets.front(),
                    [&](const Eigen::Vector2d& p) { return sheet.heightAt(p); });
}

void
addReliefs(const FacetEvidence& evidence, FacetChoice& choice)
{
  const CellPoints& cells = evidence.cells;
  const SheetGrid& grid = cells.grid();
  const float outlier = evidence.outlier();
  std::vector<std::uint8_t> is_left(grid.count(), 0);
  for (std::size_t cell = 0; cell < grid.count(); ++cell)
    is_left[cell] = cells.isInside(cell) && !cells.isEmpty(cell) &&
                    !choice.explains(cell, evidence);
  const auto least = static_cast<std::size_t>(evidence.parameters.min_relief /
                                              (grid.size * grid.size));
  choice.label.resize(grid.count(), 0);
  const std::size_t before = choice.facets.size();
  for (const std::vector<std::size_t>& piece : piecesOf(grid, is_left)) {
    if (piece.size() < least && !(before == 0 && choice.facets.empty()))
      continue;
    FacetProposal facet;
    facet.slab = reliefOf(evidence, piece);
    FacetCosts costs = costsOf(facet.slab, evidence);
    // It is known where it was seen: elsewhere it explains nothing.
    std::vector<std::uint8_t> is_own(grid.count(), 0);
    for (const std::size_t cell : piece)
      is_own[cell] = 1;
    for (std::size_t cell = 0; cell < grid.count(); ++cell)
      if (!is_own[cell] && cells.isInside(cell) && !cells.isEmpty(cell))
        costs.cost[cell] = 2 * outlier;
    for (const std::size_t cell : piece)
      choice.label[cell] = static_cast<std::int32_t>(choice.facets.size());
    choice.facets.push_back(std::move(facet));
    choice.costs.push_back(std::move(costs));
  }
  if (choice.facets.size() > before)
    labelCells(choice.costs, evidence, choice.label);
}

} // namespace pcl::sedr

// SPDX-License-Identifier: BSD-3-Clause
#include "facet_choice.h"

#include "floor_pieces.h"
#include "sheet_fit.h"
#include "sheet_pieces.h"

#include "../surface/cell_pieces.h"

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

} // namespace pcl::sedr

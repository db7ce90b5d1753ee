// SPDX-License-Identifier: BSD-3-Clause
#include "sheet_relief.h"

#include "../surface/cell_pieces.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::sedr {

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

// SPDX-License-Identifier: BSD-3-Clause
#include "sheet_relief.h"

#include "../surface/cell_pieces.h"
#include "sheet_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::sedr {

PlanSlab
reliefOf(const std::vector<Eigen::Vector3d>& points, double spacing)
{
  constexpr double deviation = 0.02;
  constexpr std::size_t min_points = 6;
  PlanSlab slab = fitPlane(points);
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& p : points)
    box.extend(p.head<2>());
  SlabCurve relief;
  relief.kind = CurveKind::Relief;
  relief.spacing = spacing;
  relief.centre = box.min() - Eigen::Vector2d::Constant(spacing);
  const Eigen::Vector2d extent = box.sizes() / spacing;
  relief.columns = static_cast<std::size_t>(extent.x()) + 4;
  const auto rows = static_cast<std::size_t>(extent.y()) + 4;
  relief.heights.assign(relief.columns * rows, 0);
  std::vector<std::int32_t> known(relief.heights.size(), FacetSheet::none);
  std::vector<std::vector<Eigen::Vector3d>> near(relief.heights.size());
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector2d at = (p.head<2>() - relief.centre) / spacing;
    for (const double y : {std::floor(at.y()), std::floor(at.y()) + 1})
      for (const double x : {std::floor(at.x()), std::floor(at.x()) + 1})
        near[static_cast<std::size_t>(y) * relief.columns + static_cast<std::size_t>(x)]
            .push_back(p);
  }
  for (std::size_t k = 0; k < near.size(); ++k) {
    if (near[k].size() < min_points)
      continue;
    PlanSlab plane = fitPlane(near[k]);
    refineShape(ShapeKind::Plane, near[k], deviation, plane);
    const Eigen::Vector2d place =
        relief.centre +
        spacing * Eigen::Vector2d(static_cast<double>(k % relief.columns),
                                  static_cast<double>(k / relief.columns));
    const auto [low, high] =
        std::minmax_element(near[k].begin(), near[k].end(),
                            [](const auto& a, const auto& b) { return a.z() < b.z(); });
    relief.heights[k] = std::clamp(plane.heightAt(place), low->z(), high->z());
    known[k] = static_cast<std::int32_t>(k);
  }
  SheetGrid grid;
  grid.columns = static_cast<int>(relief.columns);
  grid.rows = static_cast<int>(rows);
  fillNearest(grid, known);
  for (std::size_t k = 0; k < known.size() && known[k] >= 0; ++k)
    relief.heights[k] = relief.heights[static_cast<std::size_t>(known[k])];
  if (known.front() >= 0)
    slab.curve = std::make_shared<const SlabCurve>(std::move(relief));
  return slab;
}

void
addReliefs(const FacetEvidence& evidence, FacetChoice& choice)
{
  constexpr std::size_t max_points = 200000;
  const CellPoints& cells = evidence.cells;
  const SheetGrid& grid = cells.grid();
  const float outlier = evidence.outlier();
  std::vector<std::uint8_t> is_left(grid.count(), 0);
  for (std::size_t cell = 0; cell < grid.count(); ++cell)
    is_left[cell] =
        cells.isInside(cell) && !cells.isEmpty(cell) &&
        (choice.facets.empty() ||
         !evidence.isExplained(
             choice.costs[static_cast<std::size_t>(choice.label[cell])].cost[cell]));
  const auto least = static_cast<std::size_t>(evidence.parameters.min_relief /
                                              (grid.size * grid.size));
  choice.label.resize(grid.count(), 0);
  const std::size_t before = choice.facets.size();
  for (const std::vector<std::size_t>& piece : piecesOf(grid, is_left)) {
    if (piece.size() < least && !(before == 0 && choice.facets.empty()))
      continue;
    FacetProposal facet;
    facet.slab =
        reliefOf(cells.pointsOf(piece, max_points), evidence.parameters.relief_spacing);
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

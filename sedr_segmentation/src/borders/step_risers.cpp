// SPDX-License-Identifier: BSD-3-Clause
#include "sheet_cracks.h"
#include "sheet_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief The lowest and the highest of the facets near a cell, above its middle. */
std::pair<double, double>
heightsAbout(const FacetSheet& sheet, std::size_t cell)
{
  const auto reach = static_cast<int>(std::ceil(SheetCracks::riser_reach));
  const SheetGrid& grid = sheet.grid;
  std::vector<std::int32_t> labels;
  grid.forAllWithin(cell, reach, [&](std::size_t near) {
    const std::int32_t label = sheet.label[near];
    if (std::find(labels.begin(), labels.end(), label) == labels.end())
      labels.push_back(label);
  });
  const auto heightOf = [&](std::int32_t label) {
    return sheet.facets[static_cast<std::size_t>(label)].heightAt(grid.centre(cell));
  };
  std::pair<double, double> heights(heightOf(labels.front()), heightOf(labels.front()));
  for (const std::int32_t label : labels) {
    heights.first = std::min(heights.first, heightOf(label));
    heights.second = std::max(heights.second, heightOf(label));
  }
  return heights;
}

/** @brief Whether a cell lies off the walls, whose points are no riser's. */
bool
isOffWalls(const FacetSheet& sheet, std::size_t cell)
{
  constexpr int border = 2; // cells
  bool is_inside = true;
  const bool is_off_rim = sheet.grid.forAllWithin(cell, border, [&](std::size_t near) {
    is_inside = is_inside && sheet.is_inside[near] != 0;
  });
  return is_inside && is_off_rim;
}

} // namespace

std::vector<Eigen::Vector3d>
pointsOfRisers(const FacetSheet& sheet,
               const PointView& scan,
               const std::vector<int>& indices)
{
  std::vector<std::pair<double, double>> heights(sheet.grid.count());
  for (std::size_t cell = 0; cell < heights.size(); ++cell)
    if (isOffWalls(sheet, cell))
      heights[cell] = heightsAbout(sheet, cell);
  std::vector<Eigen::Vector3d> points;
  const std::size_t size = indices.empty() ? scan.size() : indices.size();
  for (std::size_t k = 0; k < size; ++k) {
    const std::size_t i = indices.empty() ? k : static_cast<std::size_t>(indices[k]);
    if (!scan.isFinite(i))
      continue;
    const Eigen::Vector3d p = scan[i].cast<double>();
    const std::size_t cell = sheet.grid.at(p.head<2>());
    if (cell < heights.size() && p.z() > heights[cell].first &&
        p.z() < heights[cell].second)
      points.push_back(p);
  }
  return points;
}

} // namespace pcl::sedr

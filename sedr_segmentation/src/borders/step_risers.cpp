// SPDX-License-Identifier: BSD-3-Clause
#include "../sheets/shape_proposals.h"
#include "../surface/riser_bins.h"
#include "sheet_cracks.h"
#include "sheet_plan.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Checks whether a cell is at a wall, whose points are no riser's. */
bool
isAtWall(const FacetSheet& sheet, std::size_t cell)
{
  bool is_inside = true;
  return !sheet.grid.forAllWithin(cell, RiserBins::to_wall, [&](std::size_t near) {
    is_inside = is_inside && sheet.is_inside[near] != 0;
  }) || !is_inside;
}

/** @brief The lowest and the highest of the facets near a cell, above its middle. */
std::pair<double, double>
heightsAbout(const FacetSheet& sheet, std::size_t cell)
{
  std::int32_t last = FacetSheet::none;
  std::pair<double, double> heights(std::numeric_limits<double>::infinity(),
                                    -std::numeric_limits<double>::infinity());
  sheet.grid.forAllWithin(
      cell, static_cast<int>(2 * SheetCracks::reach), [&](std::size_t near) {
        if (sheet.label[near] == last)
          return;
        last = sheet.label[near];
        const double height = sheet.facets[static_cast<std::size_t>(last)].heightAt(
            sheet.grid.centre(cell));
        heights = {std::min(heights.first, height), std::max(heights.second, height)};
      });
  return heights;
}

} // namespace

std::vector<Eigen::Vector3d>
pointsOfRisers(const FacetSheet& sheet,
               const PointView& scan,
               const std::vector<int>& indices)
{
  const double margin = facet_band * sheet.noise;
  std::vector<std::pair<double, double>> heights(sheet.grid.count());
  for (std::size_t cell = 0; cell < heights.size(); ++cell) {
    heights[cell] = heightsAbout(sheet, cell);
    auto& [low, high] = heights[cell];
    if (!(high - low > margin))
      high = low - margin; // no step
    else if (isAtWall(sheet, cell))
      high = low + margin; // only where the lower facet ends
  }
  std::vector<Eigen::Vector3d> points;
  forAllOver(sheet.grid, scan, indices,
             [&](std::size_t cell, const Eigen::Vector3d& p) {
               const auto& [low, high] = heights[cell];
               if (p.z() > low - margin && p.z() < high)
                 points.push_back(p);
             });
  return points;
}

} // namespace pcl::sedr

// SPDX-License-Identifier: BSD-3-Clause
#include "cell_points.h"
#include "shape_fit.h"

#include "sheet_fit.h"

#include <cmath>

namespace pcl {
namespace sedr {

double
slopingShare(const std::vector<Eigen::Vector3d>& points)
{
  constexpr double patch = 0.5;            // metres
  constexpr double level = 4 * M_PI / 180; // planes of level ceilings lean by 3 degrees
  constexpr double smooth = 1.5;           // deviations
  constexpr std::size_t least_points = 20;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& p : points)
    box.extend(p.head<2>());
  if (box.isEmpty())
    return 0;
  const auto gridOf = [&](double size) {
    SheetParameters parameters;
    parameters.cell_size = size;
    return sheetGrid(box, parameters);
  };
  const SheetGrid fine = gridOf(SheetParameters().cell_size);
  const std::vector<std::uint8_t> all_fine(fine.count(), 1);
  const double noise = CellPoints(fine, all_fine, points).noise();
  const SheetGrid grid = gridOf(patch);
  const std::vector<std::uint8_t> all(grid.count(), 1);
  const CellPoints patches(grid, all, points);
  std::size_t seen = 0;
  std::size_t sloping = 0;
  for (std::size_t cell = 0; cell < grid.count(); ++cell) {
    const std::vector<Eigen::Vector3d> own(patches.begin(cell), patches.end(cell));
    if (own.size() < least_points)
      continue;
    ++seen;
    const PlanSlab plane = fitPlane(own);
    double sum = 0;
    for (const Eigen::Vector3d& p : own)
      sum += std::pow(distanceOf(plane, p), 2);
    const double deviation = std::hypot(smooth * noise, SheetParameters().unevenness);
    if (plane.plane[2] < std::cos(level) &&
        sum < deviation * deviation * static_cast<double>(own.size()))
      ++sloping;
  }
  return seen == 0 ? 0 : static_cast<double>(sloping) / static_cast<double>(seen);
}

} // namespace sedr
} // namespace pcl

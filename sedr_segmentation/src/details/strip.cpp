// SPDX-License-Identifier: BSD-3-Clause
#include "strip.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl::sedr {

Strip
stripOf(const CellMask& cells, const CellGrid& grid)
{
  Strip strip;
  std::vector<Eigen::Vector2d> places;
  for (std::size_t i = 0; i < cells.values().size(); ++i)
    if (cells.values()[i]) {
      places.push_back(grid.centre(cells.cellAt(i)));
      strip.middle += places.back();
    }
  if (places.empty())
    return strip;
  const auto count = static_cast<double>(places.size());
  strip.middle /= count;
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const auto& p : places)
    scatter += (p - strip.middle) * (p - strip.middle).transpose() / count;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(scatter);
  strip.direction = solver.eigenvectors().col(1);
  strip.length = std::sqrt(12 * std::max(0.0, solver.eigenvalues()[1]));
  strip.width = std::sqrt(12 * std::max(0.0, solver.eigenvalues()[0]));
  return strip;
}

bool
wallGoesOn(const Strip& strip,
           const CellGrid& grid,
           const std::function<bool(Cell)>& is_wall)
{
  for (const double side : {-1.0, 1.0}) {
    int walls = 0;
    for (const double beyond : {0.15, 0.2, 0.25, 0.3}) {
      const Eigen::Vector2d p =
          strip.middle + side * (strip.length / 2 + beyond) * strip.direction;
      walls += is_wall(grid.at(p.x(), p.y())) ? 1 : 0;
    }
    if (walls >= 3)
      return true;
  }
  return false;
}

} // namespace pcl::sedr

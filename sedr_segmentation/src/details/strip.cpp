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

} // namespace pcl::sedr

// SPDX-License-Identifier: BSD-3-Clause
#include "sheet_grid.h"

#include <utility>

namespace pcl::sedr {

SheetParameters
SheetParameters::of(const Priors& priors, bool is_floor)
{
  SheetParameters parameters;
  parameters.min_step = is_floor ? priors.min_floor_step : priors.min_ceiling_step;
  parameters.min_clear_step = priors.min_floor_step;
  parameters.min_free_area = priors.min_slab_area;
  parameters.is_floor = is_floor;
  return parameters;
}

SheetGrid
sheetGrid(const Eigen::AlignedBox2d& box,
          const SheetParameters& parameters,
          double direction)
{
  constexpr int spare = 3;
  SheetGrid grid;
  const double fitting =
      std::sqrt(box.volume() / static_cast<double>(parameters.max_cells));
  grid.size = std::max(parameters.cell_size, fitting);
  const Eigen::Rotation2Dd turn(direction);
  grid.axis = turn * Eigen::Vector2d::UnitX();
  grid.origin = turn * (box.min() - Eigen::Vector2d::Constant(spare * grid.size));
  const Eigen::Vector2d extent = box.sizes() / grid.size;
  grid.columns = static_cast<int>(std::ceil(extent.x())) + 2 * spare;
  grid.rows = static_cast<int>(std::ceil(extent.y())) + 2 * spare;
  return grid;
}

SheetGrid
gridWithin(const PlanLoop& loop, const SheetParameters& parameters)
{
  const std::vector<double> directions = wallDirections(loop);
  const double direction = directions.empty() ? 0 : directions.front();
  const Eigen::Rotation2Dd turn(-direction);
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& place : loop.polygon(parameters.cell_size))
    box.extend(turn * place);
  return sheetGrid(box, parameters, direction);
}

std::vector<std::uint8_t>
cellsWithin(const SheetGrid& grid, const PlanLoop& loop)
{
  std::vector<std::uint8_t> cells(grid.count(), 0);
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const Eigen::Vector2d p = grid.centre(cell);
    cells[cell] = loop.contains(p) || loop.distance(p) <= grid.size / 2 ? 1 : 0;
  }
  return cells;
}

std::vector<double>
wallDirections(const PlanLoop& boundary)
{
  constexpr double same = 0.035; // radians
  constexpr std::size_t most = 4;
  std::vector<std::pair<double, double>> weights; // direction, length
  for (const PlanElement& element : boundary.elements) {
    if (element.isArc())
      continue;
    const Eigen::Vector2d way = element.end - element.start;
    double direction = std::atan2(way.y(), way.x());
    direction -= M_PI / 2 * std::floor(direction / (M_PI / 2));
    const auto known =
        std::find_if(weights.begin(), weights.end(), [&](const auto& other) {
          const double off = std::abs(other.first - direction);
          return std::min(off, M_PI / 2 - off) < same;
        });
    if (known != weights.end())
      known->second += way.norm();
    else
      weights.emplace_back(direction, way.norm());
  }
  std::stable_sort(weights.begin(), weights.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::vector<double> directions;
  for (const auto& [direction, length] : weights)
    if (directions.size() < most) {
      directions.push_back(direction);
      directions.push_back(direction + M_PI / 2);
    }
  return directions;
}

} // namespace pcl::sedr

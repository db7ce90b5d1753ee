// SPDX-License-Identifier: BSD-3-Clause
#include "map_cells.h"

#include "sedr_filters/src/grids/cell_mask.h"

#include <array>
#include <cmath>
#include <limits>

namespace pcl::sedr::tools {

Eigen::Vector2d
labelPlace(const CellSet& cells, double cell_size)
{
  const CellGrid grid(cell_size);
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < cells.size(); ++i)
    mean += grid.centre(cells[i]) / static_cast<double>(cells.size());
  constexpr std::uint64_t max_cells = 4000000;
  const CellBox box = grown(boxOf(cells), 1);
  std::vector<float> depth; // squared distance of a cell from the edge of the set
  if (box.count() <= max_cells)
    depth = squaredDistances(inverted(CellMask(cells, box)));
  const auto row = static_cast<std::size_t>(box.high.x - box.low.x + 1);
  Eigen::Vector2d best = mean;
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Eigen::Vector2d place = grid.centre(cells[i]);
    const std::size_t at = static_cast<std::size_t>(cells[i].y - box.low.y) * row +
                           static_cast<std::size_t>(cells[i].x - box.low.x);
    const double inside = depth.empty() ? 0 : cell_size * std::sqrt(depth[at]);
    const double score = 4 * inside - (place - mean).norm();
    if (score <= most)
      continue;
    most = score;
    best = place;
  }
  return best;
}

void
addTo(CellSet& cells, const CellSet& more)
{
  cells = unite(cells, more);
}

std::vector<Eigen::Vector2d>
placesOf(const PointView& points, const pcl::Indices& indices)
{
  std::vector<Eigen::Vector2d> places;
  places.reserve(indices.size());
  for (const auto index : indices) {
    const auto i = static_cast<std::size_t>(index);
    if (points.isFinite(i))
      places.emplace_back(points[i].head<2>().cast<double>());
  }
  return places;
}

Colour
ceilingShade(std::size_t room)
{
  static constexpr std::array<Colour, 4> shades{
      {colours::ceiling, lightened(colours::ceiling, 0.5),
       darkened(colours::ceiling, 0.25),
       mixed(colours::ceiling, Colour{220, 210, 90}, 0.6)}};
  return shades[room % shades.size()];
}

std::string
counted(std::size_t number, const std::string& thing)
{
  return std::to_string(number) + " " + thing + (number == 1 ? "" : "s");
}

} // namespace pcl::sedr::tools

// SPDX-License-Identifier: BSD-3-Clause
#include "height_bends.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief Returns where between two cells, from 0 to 1, the ceiling is midway between
 * the planes of their labels. This interpolates contour lines between cells. */
double
shareOfWay(const HeightMap& map, std::size_t from, std::size_t to, const CellGrid& grid)
{
  const Eigen::Vector2d place = grid.centre(map.room.cellAt(from));
  const double midway = (map.slabOf(map.label[from]).heightAt(place) +
                         map.slabOf(map.label[to]).heightAt(place)) /
                            2 -
                        map.main.heightAt(place);
  const double rise = map.relief[to] - map.relief[from];
  const double share = (midway - map.relief[from]) / rise;
  return std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.5;
}

} // namespace

BentEdges
bentEdges(const HeightMap& map, const CellGrid& grid)
{
  constexpr int reach = 2; // cells
  BentEdges edges{{}, CellMask(map.room.box())};
  CellMask sharp(map.room.box()); // where a step is
  if (map.bends.empty())
    return edges;
  const auto isBent = [&](std::size_t i, std::size_t j) {
    const std::int32_t a = map.label[i];
    const std::int32_t b = map.label[j];
    if (a == b || map.bends.count({a, b}) == 0)
      return false;
    const Eigen::Vector2d place = grid.centre(map.room.cellAt(i));
    const double step = map.slabOf(a).heightAt(place) - map.slabOf(b).heightAt(place);
    return 2 * std::abs(map.relief[i] - map.relief[j]) < std::abs(step);
  };
  for (std::size_t i = 0; i < map.relief.size(); ++i) {
    const Cell cell = map.room.cellAt(i);
    for (const Cell d : {Cell{1, 0}, Cell{0, 1}}) {
      const Cell to{cell.x + d.x, cell.y + d.y};
      if (!map.room.at(cell) || !map.room.at(to))
        continue;
      if (!isBent(i, map.room.indexOf(to))) {
        if (map.label[i] != map.label[map.room.indexOf(to)])
          sharp.set(cell, 1);
        continue;
      }
      const Eigen::Vector2d middle =
          grid.centre(cell) + shareOfWay(map, i, map.room.indexOf(to), grid) *
                                  (grid.centre(to) - grid.centre(cell));
      const Eigen::Vector2d along(d.y, d.x);
      for (double s = 0.005 - grid.size() / 2; s < grid.size() / 2; s += 0.01)
        edges.points.emplace_back(middle + s * along);
      edges.cells.set(cell, 1);
      edges.cells.set(to, 1);
    }
  }
  edges.cells = subtract(dilated(edges.cells, reach), dilated(sharp, reach));
  return edges;
}

} // namespace pcl::sedr

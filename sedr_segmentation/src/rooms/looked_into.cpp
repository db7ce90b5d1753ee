// SPDX-License-Identifier: BSD-3-Clause
#include "looked_into.h"

#include <pcl/sedr_filters/cell_grid.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace pcl {
namespace sedr {

namespace {

/** @brief Share of a part's width along the wall of an opening, beside the opening, at
 * which its air reaches that wall; 1 where it is hardly wider than the opening. */
double
shareAtWall(const BuildingRoom& part, const RoomOpening& opening, double cell_size)
{
  constexpr double at_wall = 0.35; // metres from the middle of the wall
  constexpr double farthest = 3.0; // metres beside the opening that are looked at
  const CellGrid grid(cell_size);
  const Eigen::Vector2d normal(-opening.direction.y(), opening.direction.x());
  std::set<long> wide;
  std::set<long> reaching;
  for (const RoomColumn& column : part.columns) {
    const Eigen::Vector2d from = grid.centre(column.cell) - opening.middle;
    const double along = opening.direction.dot(from);
    const double beside = std::abs(along) - opening.width / 2;
    if (beside < cell_size || beside > farthest)
      continue;
    const long at = std::lround(along / cell_size);
    wide.insert(at);
    if (std::abs(normal.dot(from)) <= at_wall)
      reaching.insert(at);
  }
  constexpr std::size_t hardly_wider = 3; // columns
  return wide.size() <= hardly_wider
             ? 1
             : static_cast<double>(reaching.size()) / static_cast<double>(wide.size());
}

} // namespace

std::vector<std::uint8_t>
lookedInto(const std::vector<BuildingRoom>& parts,
           const std::vector<RoomOpening>& openings,
           double cell_size)
{
  constexpr double walled = 0.75; // share of the outline
  constexpr double seen = 0.5;    // share of the wall with the opening
  std::vector<std::uint8_t> is_looked_into(parts.size(), 0);
  for (std::size_t p = 1; p < parts.size(); ++p) {
    if (parts[p].enclosure >= walled)
      continue;
    bool has_opening = false;
    double best = 0;
    for (const RoomOpening& opening : openings) {
      const std::size_t other = opening.a == p ? opening.b : opening.a;
      if ((opening.a != p && opening.b != p) || other > p)
        continue; // what is smaller was looked into from here
      has_opening = true;
      best = std::max(best, shareAtWall(parts[p], opening, cell_size));
    }
    constexpr double walled_apart = 0.57;
    is_looked_into[p] = has_opening ? best < seen : parts[p].enclosure < walled_apart;
  }
  return is_looked_into;
}

} // namespace sedr
} // namespace pcl

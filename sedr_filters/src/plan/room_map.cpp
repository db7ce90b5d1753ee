// SPDX-License-Identifier: BSD-3-Clause
#include "room_map.h"

#include <algorithm>
#include <limits>
#include <map>

namespace pcl::sedr {

namespace {

using Votes = std::map<std::uint32_t, std::size_t>;

/** @brief Gives cells without a room (0) that of a neighbour, the lowest of several,
 * step by step. */
void
growRooms(const CellSet& cells, std::vector<std::uint32_t>& rooms)
{
  std::vector<std::uint32_t> before;
  while (before != rooms) {
    before = rooms;
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (before[i] == 0)
        forEachAround(cells, cells[i], 1, [&](std::size_t j) {
          if (before[j] != 0 && (rooms[i] == 0 || before[j] < rooms[i]))
            rooms[i] = before[j];
        });
  }
}

/** @brief Counts the points of each room in each cell, without those of no room. */
std::vector<Votes>
countRooms(const CellGrid& grid,
           const PointView& points,
           const std::vector<std::uint32_t>& room,
           const pcl::Indices& indices,
           const CellSet& cells)
{
  std::vector<Votes> votes(cells.size());
  for (const auto index : indices) {
    const auto i = static_cast<std::size_t>(index);
    const Eigen::Vector3f p = points[i];
    if (room[i] != 0 && points.isFinite(i) && grid.holds(p.x(), p.y()))
      ++votes[cells.find(grid.at(p.x(), p.y()))][room[i]];
  }
  return votes;
}

std::uint32_t
mostFrequent(const Votes& votes)
{
  return std::max_element(
             votes.begin(), votes.end(),
             [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

} // namespace

RoomMap::RoomMap(const CellGrid& grid,
                 const PointView& points,
                 const std::vector<std::uint32_t>& room,
                 const pcl::Indices& ceiling,
                 const pcl::Indices& detail)
    : grid_(grid)
    , points_(points)
    , cells_(unite(CellSet(grid, points, ceiling), CellSet(grid, points, detail)))
{
  // Without ceiling, details decide: a detail with a room gives it to the cell, the
  // others take the cell's room.
  const auto by_ceiling = countRooms(grid, points, room, ceiling, cells_);
  const auto by_detail = countRooms(grid, points, room, detail, cells_);
  room_of_cell_.assign(cells_.size(), 0);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const Votes& votes = by_ceiling[i].empty() ? by_detail[i] : by_ceiling[i];
    if (!votes.empty())
      room_of_cell_[i] = mostFrequent(votes);
  }
  growRooms(cells_, room_of_cell_);
  noteCeilings(room, ceiling);
}

void
RoomMap::noteCeilings(const std::vector<std::uint32_t>& room,
                      const pcl::Indices& ceiling)
{
  above_.resize(cells_.size());
  for (const auto index : ceiling) {
    const auto i = static_cast<std::size_t>(index);
    const Eigen::Vector3f p = points_[i];
    if (room[i] == 0 || !points_.isFinite(i) || !grid_.holds(p.x(), p.y()))
      continue;
    auto& here = above_[cells_.find(grid_.at(p.x(), p.y()))];
    auto own = std::find_if(here.begin(), here.end(),
                            [&](const Above& a) { return a.room == room[i]; });
    if (own == here.end())
      own = here.insert(own, {room[i], 0, 0});
    own->points += 1;
    own->height += (p.z() - own->height) / static_cast<double>(own->points);
  }
}

std::uint32_t
RoomMap::roomOver(pcl::index_t index) const
{
  const auto i = static_cast<std::size_t>(index);
  const Eigen::Vector3f p = points_[i];
  if (!points_.isFinite(i) || !grid_.holds(p.x(), p.y()))
    return 0;
  const std::size_t cell = cells_.find(grid_.at(p.x(), p.y()));
  if (cell == CellSet::npos)
    return 0;
  // Neighbouring rooms have ceilings less than a storey apart.
  constexpr double noise = 0.15;     // metres
  constexpr double min_storey = 1.5; // metres
  const std::vector<Above>& here = above_[cell];
  double lowest = std::numeric_limits<double>::infinity();
  for (const Above& a : here)
    if (a.height >= p.z() - noise)
      lowest = std::min(lowest, a.height);
  const Above* most = nullptr;
  for (const Above& a : here)
    if (a.height >= lowest && a.height < lowest + min_storey &&
        (!most || a.points > most->points))
      most = &a;
  return most ? most->room : room_of_cell_[cell];
}

} // namespace pcl::sedr

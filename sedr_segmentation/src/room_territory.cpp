// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/room_territory.h>

#include <cmath>

namespace pcl {
namespace sedr {

namespace {

/** @brief How far from a room's ceiling its walls may be, in cells. */
constexpr int reach_in_cells = 14;

} // namespace

RoomTerritory::RoomTerritory(const CellGrid& grid, const std::vector<CellSet>& scopes)
: grid_(grid)
{
  CellSet all;
  for (const auto& scope : scopes)
    all = unite(all, scope);
  const CellBox box = grown(boxOf(all), reach_in_cells + 1);
  problem_ = maskProblem(box);
  if (!problem_.empty())
    return;
  frame_ = inverted(CellMask(box));
  room_.assign(frame_.values().size(), -1);
  for (std::size_t r = 0; r < scopes.size(); ++r)
    for (std::size_t i = 0; i < scopes[r].size(); ++i) {
      auto& room = room_[frame_.indexOf(scopes[r][i])];
      room = room < 0 ? static_cast<std::int32_t>(r) : room;
    }
  growLabels(frame_, reach_in_cells, room_);
}

std::int32_t
RoomTerritory::roomAt(const Eigen::Vector3f& p) const
{
  if (!std::isfinite(p.z()) || !grid_.holds(p.x(), p.y()))
    return -1;
  const Cell cell = grid_.at(p.x(), p.y());
  return frame_.isInside(cell) ? room_[frame_.indexOf(cell)] : -1;
}

} // namespace sedr
} // namespace pcl

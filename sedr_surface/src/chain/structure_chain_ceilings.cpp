// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/base/labels.h"

#include "chain_run.h"

#include "sedr_filters/src/base/plane_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace pcl::sedr {

std::size_t
ChainRun::labelLowerCeilings(std::size_t region)
{
  const PointView points(*chain_.cloud);
  const CellGrid& columns = chain_.getBuilding().grid;
  std::vector<CellKey> level_keys;
  for (const RoomColumn& column : chain_.getBuilding().rooms[region].columns)
    if (column.is_level)
      level_keys.push_back(keyOf(column.cell));
  const CellSet level(std::move(level_keys));
  std::size_t found = 0;
  double lowest = std::numeric_limits<double>::infinity();
  for (const int i : regions_[region].ceiling) {
    const auto at = static_cast<std::size_t>(i);
    if (chain_.labels[at] != 0)
      continue;
    if (!level.contains(columns.at(points[at].x(), points[at].y()))) {
      give(i, StructureLabel::Ceiling, region + 1); // vault or roof
      continue;
    }
    give(i, StructureLabel::Detail, region + 1);
    ++found;
    lowest = std::min<double>(lowest, points[at].z());
  }
  labelRisers(region);
  // Below a soffit, walls grow from the floor's boundary, as below any detail.
  double& slice = slice_height_[region];
  if (found > 0 && !(slice < lowest))
    slice = lowest - chain_.plane_detection.getGridSize();
  return found;
}

void
ChainRun::labelRisers(std::size_t region)
{
  constexpr double below = 0.4; // metres: what goes on so far down is a wall
  constexpr double rim = 0.1;   // metres, of noise
  const PointView points(*chain_.cloud);
  const CellGrid& grid = chain_.getBuilding().grid;
  std::map<CellKey, float> lowest; // of the parts of the ceiling, near each cell
  for (const int i : regions_[region].ceiling) {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    if (chain_.labels[static_cast<std::size_t>(i)] != valueOf(StructureLabel::Detail))
      continue;
    const Cell cell = grid.at(p.x(), p.y());
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const auto known =
            lowest.emplace(keyOf({cell.x + dx, cell.y + dy}), p.z()).first;
        known->second = std::min(known->second, p.z());
      }
  }
  if (lowest.empty())
    return;
  std::map<CellKey, pcl::Indices> risers;
  std::set<CellKey> walls;
  for (const int i : *territory_[region]) {
    const auto at = static_cast<std::size_t>(i);
    const Eigen::Vector3f p = points[at];
    if (chain_.labels[at] != 0)
      continue;
    const auto low = lowest.find(keyOf(grid.at(p.x(), p.y())));
    if (low == lowest.end())
      continue;
    if (p.z() > low->second - rim &&
        distanceAbove(regions_[region].ceiling_slab, p) < 0)
      risers[low->first].push_back(i);
    else if (p.z() < low->second - rim && p.z() > low->second - below)
      walls.insert(low->first);
  }
  for (const auto& [cell, own] : risers)
    if (walls.count(cell) == 0)
      for (const int i : own)
        give(i, StructureLabel::Detail, region + 1);
}

pcl::IndicesPtr
ChainRun::sheetPoints() const
{
  pcl::IndicesPtr sheets(new pcl::Indices);
  for (std::size_t r = 0; r < regions_.size(); ++r)
    for (const int i : regions_[r].ceiling)
      if (const auto at = static_cast<std::size_t>(i);
          at < chain_.scanned_points_ && // others fill hidden ceilings
          chain_.rooms[at] == r + 1)     // else floor of the one above
        sheets->push_back(i);
  std::sort(sheets->begin(), sheets->end());
  return sheets;
}

} // namespace pcl::sedr

// SPDX-License-Identifier: BSD-3-Clause
#include "../formats/labels.h"

#include "chain_run.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr {

CellSet
ChainRun::levelColumns(std::size_t region) const
{
  std::vector<CellKey> keys;
  for (const RoomColumn& column : chain_.getBuilding().rooms[region].columns)
    if (column.is_level)
      keys.push_back(keyOf(column.cell));
  return CellSet(std::move(keys));
}

std::size_t
ChainRun::labelLowerCeilings(std::size_t region)
{
  const PointView points(*chain_.cloud);
  const CellGrid& columns = chain_.getBuilding().grid;
  const CellSet level = levelColumns(region);
  std::size_t found = 0;
  double lowest = std::numeric_limits<double>::infinity();
  for (const int i : regions_[region].ceiling) {
    const auto at = static_cast<std::size_t>(i);
    if (chain_.labels[at] != 0)
      continue;
    chain_.rooms[at] = static_cast<std::uint32_t>(region + 1);
    if (!level.contains(columns.at(points[at].x(), points[at].y()))) {
      chain_.labels[at] = valueOf(StructureLabel::Ceiling); // vault or roof
      continue;
    }
    chain_.labels[at] = valueOf(StructureLabel::Detail);
    ++found;
    lowest = std::min<double>(lowest, points[at].z());
  }
  // Below a soffit, walls grow from the floor's boundary, as below any detail.
  double& slice = slice_height_[region];
  if (found > 0 && !(slice < lowest))
    slice = lowest - chain_.plane_detection.getGridSize();
  return found;
}

pcl::Indices
ChainRun::seenCeiling(std::size_t region) const
{
  pcl::Indices seen;
  for (const int i : regions_[region].ceiling)
    if (static_cast<std::size_t>(i) <
        chain_.scanned_points_) // others fill hidden ceilings
      seen.push_back(i);
  return seen;
}

pcl::IndicesPtr
ChainRun::sheetPoints() const
{
  pcl::IndicesPtr sheets(new pcl::Indices);
  for (std::size_t r = 0; r < regions_.size(); ++r)
    for (const int i : seenCeiling(r))
      if (chain_.rooms[static_cast<std::size_t>(i)] ==
          r + 1) // else floor of the one above
        sheets->push_back(i);
  std::sort(sheets->begin(), sheets->end());
  return sheets;
}

} // namespace pcl::sedr

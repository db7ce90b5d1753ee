// SPDX-License-Identifier: BSD-3-Clause
#include "room_columns.h"

#include <algorithm>

namespace pcl::sedr {

double
RoomColumns::topAround(Cell cell, int reach) const
{
  double top = floorAt(cell);
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx) {
      const Cell near{cell.x + dx, cell.y + dy};
      const ColumnTable::Entry* const end = columns_.end(near);
      if (columns_.begin(near) != end)
        top = std::max<double>(top, (end - 1)->z);
    }
  return std::min(top, ceilingAt(cell));
}

double
RoomColumns::upperShare(Cell cell, double top, double below, int radius) const
{
  return columns_.share(cell, middleBelow(cell, top), top - below, 6, radius);
}

bool
RoomColumns::reaches(Cell cell, double top, const CeilingGap& gap) const
{
  return columns_.share(cell, top - gap.low, top - gap.high, 1, 1) >= 1;
}

} // namespace pcl::sedr

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_segmentation/src/plan/room_outline.h"

#include "room_points.h"

#include <vector>

namespace sedr_test {

constexpr double room_height = 2.5;

/** A room of 4 m x 3 m. Its ceiling was scanned where `isSeen` is true, and its wall y
 * = 0.01 except from `hidden_from` to `hidden_to` along x. */
class CeilingScene {
public:
  explicit CeilingScene(
      const RoomPoints::InPlan& isSeen = [](double, double) { return true; },
      double hidden_from = 0,
      double hidden_to = 0)
  {
    const pcl::sedr::PlanLoop loop = rectangle(0.01, 0.01, 4.01, 3.01);
    points.slab(loop, 0);
    for (std::size_t e = 0; e < 4; ++e)
      points.wall(loop.elements[e], 0, room_height, [&](double s, double) {
        return e > 0 || s <= hidden_from || s >= hidden_to;
      });
    ceiling = points.slab(loop, room_height, isSeen);
  }

  /** Adds the four vertical sides of a box. */
  void box(double x0, double y0, double x1, double y1, double low, double high)
  {
    for (const auto& e : rectangle(x0, y0, x1, y1).elements)
      points.wall(e, low, high);
  }

  pcl::sedr::RoomOutline outline() const
  {
    const pcl::sedr::CellGrid grid(0.05);
    const pcl::sedr::CellSet seen(grid, points.view(), ceiling);
    const pcl::sedr::CellBox all = pcl::sedr::grown(pcl::sedr::boxOf(seen), 14);
    return pcl::sedr::outlineRoom(
        pcl::sedr::CellMask(seen, all), grid,
        pcl::sedr::ColumnTable(grid, all, points.view(), points.all()),
        slabAt(room_height), slabAt(0));
  }

  RoomPoints points;
  std::vector<int> ceiling;
};

/** Returns true if these are the cells of the room's complete ceiling. */
inline bool
isWholeRoom(const pcl::sedr::CellMask& room)
{
  const CeilingScene scene;
  return room.toSet().keys() == pcl::sedr::CellSet(pcl::sedr::CellGrid(0.05),
                                                   scene.points.view(), scene.ceiling)
                                    .keys();
}

inline bool
isWithin(double x, double y, double x0, double y0, double x1, double y1)
{
  return x > x0 && x < x1 && y > y0 && y < y1;
}

inline double
areaOfCells(const pcl::sedr::CellMask& mask)
{
  return static_cast<double>(mask.count()) * 0.0025;
}

} // namespace sedr_test

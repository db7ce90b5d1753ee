// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include "sedr_segmentation/src/faces/room_cells.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace sedr_test;

/** Returns the mean share of the height that was seen at places on the wall y = 5. */
double
shareOn(const pcl::sedr::PlanRoom& room, const sedr_test::RoomPoints::InSpace& keep)
{
  sedr_test::RoomPoints points(0.03, 0.002);
  const RoomParts parts = points.room(room, keep);
  pcl::sedr::RoomPoints of_room;
  of_room.ceiling = parts.ceiling;
  of_room.floor = parts.floor;
  of_room.walls = parts.walls;
  const pcl::sedr::RoomCells cells =
      pcl::sedr::roomCells(points.view(), {of_room}, {}, pcl::sedr::CellGrid(0.05), {},
                           1)
          .at(0);
  EXPECT_EQ(cells.wall_points.size(), cells.wall_shares.size());
  double sum = 0;
  double n = 0;
  for (std::size_t i = 0; i < cells.wall_points.size(); ++i)
    if (const auto& p = cells.wall_points[i];
        std::abs(p.y() - 5) < 0.02 && p.x() > 1 && p.x() < 5) {
      sum += static_cast<double>(cells.wall_shares[i]);
      ++n;
    }
  EXPECT_GT(n, 100);
  return sum / n;
}

TEST(RoomCells, APlaceOnAWallTellsTheShareOfItsHeightThatWasSeen)
{
  for (const double height : {2.5, 4.3, 9.0})
    for (const double from : {0.0, 0.3, 0.6}) {
      const auto isSeen = [&](const Eigen::Vector3d& p) {
        return p.y() < 4.9 || p.z() > from * height;
      };
      EXPECT_NEAR(shareOn(roomOf(rectangle(0, 0, 6, 5), height), isSeen), 1 - from,
                  0.12)
          << height << " from " << from;
    }
}

} // namespace

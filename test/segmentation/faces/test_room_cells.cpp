// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include "sedr_segmentation/src/arrangement/recess_cells.h"
#include "sedr_segmentation/src/faces/room_cells.h"

#include <pcl/sedr_filters/priors.h>

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

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

/** Returns how many cells are pillars and how many glass on a surface, 5 m long, that
 * ends at a soffit beside a higher ceiling and of which a share of the rays returns. */
std::pair<std::size_t, std::size_t>
pillarsAndGlass(int one_in)
{
  sedr_test::RoomPoints points(0.02, 0.002);
  pcl::sedr::PlanRoom room = roomOf(rectangle(0, 0, 9, 5), 2.6);
  room.details.emplace_back();
  room.details[0].boundary = rectangle(2, 2.6, 7, 3);
  room.details[0].slab = slabAt(2.05);
  const RoomParts parts = points.room(room, [](const Eigen::Vector3d& p) {
    return p.y() < 2.5 || p.y() > 3.1; // no wall within 2 m of the surface
  });
  const std::vector<int> surface =
      points.wall(segment({2, 2.77}, {7, 2.77}), 0, 2.05, [&](double s, double z) {
        const auto ray = std::lround(s / 0.02) + 3 * std::lround(z / 0.02);
        return ray % one_in == 0;
      });
  pcl::sedr::RoomPoints of_room;
  of_room.ceiling = joined(parts.ceiling, parts.details);
  of_room.floor = parts.floor;
  of_room.walls = joined(parts.walls, surface);
  const pcl::sedr::CellGrid grid(0.05);
  std::vector<pcl::sedr::RoomCells> cells =
      pcl::sedr::roomCells(points.view(), {of_room}, {}, grid, {}, 1);
  pcl::sedr::findGlass(points.view(), {}, {}, grid, {}, 1, cells);
  std::pair<std::size_t, std::size_t> found;
  for (double x = 2.2; x < 6.8; x += grid.size()) {
    const pcl::sedr::Cell cell = grid.at(x, 2.77);
    found.first += cells[0].pillar.at(cell) != 0;
    found.second += cells[0].glass.at(cell) != 0;
  }
  return found;
}

TEST(RoomCells, APaneUpToASoffitIsGlassAndNoPillar)
{
  EXPECT_GT(pillarsAndGlass(1).first, 80U);
  EXPECT_EQ(pillarsAndGlass(1).second, 0U);
  EXPECT_EQ(pillarsAndGlass(10).first, 0U);
  EXPECT_GT(pillarsAndGlass(10).second, 10U);
}

TEST(RecessCells, EachCellOfAWindowsRecessIsFoundHoweverItIsTurned)
{
  using namespace pcl::sedr;
  // Air was seen up to a pane 0.2 m behind the line of a wall, 4 m long.
  const CellGrid grid(0.05);
  const CellBox box{grid.at(-4, -4), grid.at(4, 4)};
  for (const double turn : {0.0, 0.3, 0.7, 1.2}) {
    StoreyLine wall = endLine({0, 0}, {std::cos(turn), std::sin(turn)}, 2, 1, 0.03);
    wall.is_end = false;
    wall.part.assign(wall.any.size(), 1);
    wall.between.assign(wall.any.size(), StoreyLine::Between::Partly);
    const Eigen::Vector2d out = leftOf(wall.curve.direction);
    RoomCells room;
    room.seen = CellMask(box);
    room.solid = room.glass = room.riser = room.pillar = room.base = room.seen;
    for (std::size_t i = 0; i < room.seen.values().size(); ++i) {
      const double depth = out.dot(grid.centre(room.seen.cellAt(i)));
      room.seen.values()[i] = depth < 0.2;
      room.glass.values()[i] = depth >= 0.2 && depth < 0.3;
    }
    const RecessCells found =
        recessCells({{0}}, {room}, {wall}, grid, Priors().max_wall).front();
    for (std::size_t i = 0; i < room.seen.values().size(); ++i) {
      const Eigen::Vector2d p = grid.centre(room.seen.cellAt(i));
      if (std::abs(wall.curve.direction.dot(p)) > 1.9)
        continue;
      if (out.dot(p) > 0.05 && out.dot(p) < 0.15) {
        EXPECT_EQ(found.open.values()[i], 1) << turn << ": " << p.transpose();
      }
      else if (out.dot(p) < -0.05) {
        EXPECT_EQ(found.open.values()[i], 0) << turn << ": " << p.transpose();
      }
    }
  }
}

} // namespace

// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include <pcl/sedr_segmentation/hidden_ceiling.h>

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

constexpr double height = 2.6;
constexpr double cell = 0.05;

/** A room of 5 m x 3 m, of whose ceiling nothing was seen beyond y = `seen_to`. */
class Scene {
public:
  explicit Scene(double seen_to)
  {
    const PlanLoop loop = rectangle(0.01, 0.01, 5.01, 3.01);
    points.slab(loop, 0);
    for (std::size_t i = 0; i < 4; ++i)
      if (i != 2)
        points.wall(loop.elements[i], 0, height);
    ceiling = points.slab(loop, height, [&](double, double y) { return y < seen_to; });
  }

  /** A straight wall. */
  void wall(double x0, double y0, double x1, double y1, double low, double high)
  {
    points.wall(segment({x0, y0}, {x1, y1}), low, high);
  }

  /** Something level: the underside of a duct or of a lintel. */
  void level(double x0, double y0, double x1, double y1, double z)
  {
    points.slab(rectangle(x0, y0, x1, y1), z);
  }

  CellMask hidden(const CellSet& others = {}) const
  {
    const CellGrid grid(cell);
    const CellSet seen(grid, points.view(), ceiling);
    const CellBox box = grown(boxOf(seen), 16);
    return hiddenCeiling(CellMask(seen, box), CellMask(others, box), grid,
                         ColumnTable(grid, box, points.view(), points.all()),
                         slabAt(height), slabAt(0));
  }

  RoomPoints points;
  std::vector<int> ceiling;
};

double
areaOf(const CellMask& mask)
{
  return static_cast<double>(mask.count()) * cell * cell;
}

/** A duct 20 cm wide from y = 2.6 hides the ceiling of 36 cm before the wall. */
Scene
roomWithDuct()
{
  Scene scene(2.65);
  scene.wall(5.01, 3.01, 0.01, 3.01, 0, height - 0.2);
  scene.level(0.05, 2.62, 4.95, 2.8, height - 0.3);
  return scene;
}

TEST(HiddenCeiling, ReachesTheWallBehindADuct)
{
  const CellMask hidden = roomWithDuct().hidden();
  // From the last cell that was seen to the cell of the wall, along all of it.
  EXPECT_NEAR(areaOf(hidden), 5 * 0.35, 0.25);
  const CellGrid grid(cell);
  EXPECT_TRUE(hidden.at(grid.at(2.5, 2.9)));
  EXPECT_FALSE(hidden.at(grid.at(2.5, 2.6)));
  EXPECT_FALSE(hidden.at(grid.at(2.5, 3.06)));
}

/** A window wall, before which the ceiling ends; the lintel ends at `top`. */
Scene
roomWithWindow(double top)
{
  Scene scene(2.8);
  scene.wall(5.01, 3.01, 4.61, 3.01, 0, top);
  scene.wall(4.61, 3.01, 0.41, 3.01, 0, 0.4);
  scene.wall(4.61, 3.01, 0.41, 3.01, height - 0.1, top);
  scene.wall(0.41, 3.01, 0.01, 3.01, 0, top);
  return scene;
}

TEST(HiddenCeiling, ReachesTheWallOfAWindowBehindASlotForACurtain)
{
  const CellMask hidden = roomWithWindow(height + 0.15).hidden();
  EXPECT_NEAR(areaOf(hidden), 5 * 0.2, 0.15);
  const CellGrid grid(cell);
  EXPECT_TRUE(hidden.at(grid.at(2.5, 2.9)));
  EXPECT_FALSE(hidden.at(grid.at(2.5, 3.06)));
}

TEST(HiddenCeiling, IsNotBehindAWindowWhoseWallEndsAtTheCeiling)
{
  EXPECT_EQ(0U, roomWithWindow(height).hidden().count());
}

TEST(HiddenCeiling, OfAWholeCeilingIsNothing)
{
  Scene scene(9);
  scene.wall(5.01, 3.01, 0.01, 3.01, 0, height);
  EXPECT_EQ(0U, scene.hidden().count());
}

TEST(HiddenCeiling, IsNotBehindAWall)
{
  Scene scene = roomWithDuct();
  scene.wall(5.01, 2.66, 0.01, 2.66, 0, height);
  EXPECT_EQ(0U, scene.hidden().count());
}

TEST(HiddenCeiling, IsNotWhereNoWallStandsBehind)
{
  Scene scene(2.65);
  scene.level(0.05, 2.62, 4.95, 2.8, height - 0.3);
  EXPECT_EQ(0U, scene.hidden().count());
}

TEST(HiddenCeiling, IsNotFarFromWhatWasSeen)
{
  Scene scene(2.2);
  scene.wall(5.01, 3.01, 0.01, 3.01, 0, height);
  EXPECT_EQ(0U, scene.hidden().count());
}

TEST(HiddenCeiling, IsNoNicheWithItsTop)
{
  Scene scene(2.65);
  scene.wall(5.01, 3.01, 0.01, 3.01, 0, height - 0.4);
  scene.wall(5.01, 2.66, 0.01, 2.66, height - 0.4, height);
  scene.level(0.05, 2.66, 4.95, 3, height - 0.4);
  EXPECT_EQ(0U, scene.hidden().count());
}

TEST(HiddenCeiling, TakesNothingFromOtherRooms)
{
  const Scene scene = roomWithDuct();
  const CellGrid grid(cell);
  std::vector<CellKey> strip;
  for (double x = 0.03; x < 5; x += cell)
    for (double y = 2.73; y < 3; y += cell)
      strip.push_back(keyOf(grid.at(x, y)));
  EXPECT_EQ(0U, scene.hidden(CellSet(strip)).count());
}

/** The cells from y = `from` to 4 along the whole room. */
CellSet
cellsBeyond(double from)
{
  const CellGrid grid(cell);
  std::vector<CellKey> cells;
  for (double x = 0.03; x < 5; x += cell)
    for (double y = from + 0.01; y < 4; y += cell)
      cells.push_back(keyOf(grid.at(x, y)));
  return CellSet(std::move(cells));
}

TEST(HiddenCeiling, IsNotBehindTheFaceThatAWallShowsToAnotherRoom)
{
  // The other room's ceiling begins at the wall's points: they are its face.
  EXPECT_EQ(0U, roomWithDuct().hidden(cellsBeyond(3.05)).count());
  // In noise of 2 cm, the face has points a cell farther from it.
  EXPECT_EQ(0U, roomWithDuct().hidden(cellsBeyond(3.10)).count());
  // Beyond a partition of 10 cm, the points are those of this room's face.
  EXPECT_NEAR(areaOf(roomWithDuct().hidden(cellsBeyond(3.15))), 5 * 0.35, 0.25);
}

} // namespace

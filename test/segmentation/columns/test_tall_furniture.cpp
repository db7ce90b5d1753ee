// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/plan/room_evidence.h"

#include "sedr_segmentation/src/columns/tall_furniture.h"
#include "sedr_segmentation/src/profiles/ceiling_gap.h"

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

constexpr double height = 2.5;

/** Returns the cells of objects that end below the ceiling of a room. */
CellMask
furnitureIn(const RoomPoints& points, const CellMask& seen)
{
  const CellGrid grid(0.05);
  const ColumnTable columns(grid, seen.box(), points.view(), points.all());
  return tallFurniture(
      seen, verticalCells(seen.box(), grid, columns, slabAt(height), slabAt(0), 2),
      grid, columns, slabAt(height), slabAt(0), {});
}

/** A room of 4 m x 3 m with a box of 2 m x 0.6 m at its left wall, up to `top`. The
 * ceiling above it is seen for `depth` metres. */
struct WardrobeRoom {
  WardrobeRoom(double top, double depth)
  {
    const PlanLoop loop = rectangle(0.01, 0.01, 4.01, 3.01);
    const auto isHidden = [](double x, double y) { return x < 0.61 && y < 2.01; };
    parts.floor =
        points.slab(loop, 0, [&](double x, double y) { return !isHidden(x, y); });
    for (const auto& e : loop.elements)
      parts.walls =
          joined(parts.walls, points.wall(e, 0, height, [&](double s, double) {
            const Eigen::Vector2d p = e.pointAt(s);
            return !isHidden(p.x(), p.y());
          }));
    parts.ceiling = points.slab(loop, height, [&](double x, double y) {
      return !(x < 0.61 - depth && y < 2.01 - depth);
    });
    box = joined(points.wall(segment({0.61, 2.01}, {0.61, 0.01}), 0, top),
                 points.wall(segment({0.01, 2.01}, {0.61, 2.01}), 0, top));
  }

  CellMask furniture() const
  {
    const CellGrid grid(0.05);
    const CellSet seen(grid, points.view(), parts.ceiling);
    const CellBox all = grown(boxOf(seen), 14);
    return furnitureIn(points, CellMask(seen, all));
  }

  RoomPoints points;
  RoomParts parts;
  std::vector<int> box;
};

TEST(CeilingGap, BeginsWhereTheNoiseOfTheCeilingEnds)
{
  PlanSlab ceiling;
  EXPECT_DOUBLE_EQ(gapBelow(ceiling).high, 0.03);
  EXPECT_DOUBLE_EQ(gapBelow(ceiling).low, 0.085);
  ceiling.residual = 0.02;
  EXPECT_DOUBLE_EQ(gapBelow(ceiling).high, 0.08);
  EXPECT_DOUBLE_EQ(gapBelow(ceiling).low, 0.135);
  ceiling.residual = 1;
  EXPECT_DOUBLE_EQ(gapBelow(ceiling).high, 0.1);
}

TEST(TallFurniture, IsWhatEndsBelowACeilingThatIsSeenAboveIt)
{
  for (const double gap : {0.1, 0.2, 0.6}) {
    const WardrobeRoom room(height - gap, 0.12);
    const CellMask found = room.furniture();
    const CellGrid grid(0.05);
    std::size_t covered = 0;
    for (const int i : room.box)
      covered += found.at(grid.at(room.points[i].x(), room.points[i].y()));
    EXPECT_GT(covered, 0.9 * static_cast<double>(room.box.size())) << gap;
    for (const int i : room.parts.walls) {
      const Eigen::Vector3f p = room.points[i];
      EXPECT_FALSE(p.x() > 1 && found.at(grid.at(p.x(), p.y())));
    }
  }
}

TEST(TallFurniture, IsNoWallUpToTheCeilingNorOneThatEndsWhatIsSeenOfIt)
{
  EXPECT_EQ(WardrobeRoom(height, 0).furniture().count(), 0u);
  EXPECT_EQ(WardrobeRoom(height, 0.12).furniture().count(), 0u)
      << "a ceiling behind a wall is that of the next room";
  EXPECT_EQ(WardrobeRoom(height - 0.3, 0).furniture().count(), 0u)
      << "a duct may hide the top of a wall";
}

TEST(TallFurniture, IsSeenBelowTheCeilingAlongHalfOfItOrIsNone)
{
  // A screen across a room of 4 m x 3 m, 30 cm below the ceiling. Beyond it the ceiling
  // is seen along `seen` metres, half a metre deep.
  const auto furnitureFor = [](double seen) {
    RoomPoints points;
    const PlanLoop loop = rectangle(0.01, 0.01, 4.01, 3.01);
    const auto ceiling = points.slab(loop, height, [&](double x, double y) {
      return x < 2.01 || (x < 2.51 && y < seen);
    });
    points.slab(loop, 0);
    points.wall(segment({2.01, 3.01}, {2.01, 0.01}), 0, height - 0.3);
    const CellGrid grid(0.05);
    const CellSet cells(grid, points.view(), ceiling);
    const CellBox all = grown(boxOf(cells), 14);
    return furnitureIn(points, CellMask(cells, all)).count();
  };
  EXPECT_GT(furnitureFor(3.01), 50u);
  EXPECT_GT(furnitureFor(2.0), 30u);
  EXPECT_LT(furnitureFor(2.0), 0.75 * static_cast<double>(furnitureFor(3.01)))
      << "only where the ceiling is seen";
  EXPECT_EQ(furnitureFor(1.0), 0u) << "a wall with what a gap in it shows";
}

TEST(TallFurniture, BelowANoisyCeilingNeedsALargerGap)
{
  PlanSlab ceiling = slabAt(height);
  ceiling.residual = 0.001;
  EXPECT_NEAR(gapBelow(ceiling).high, 0.03, 1e-9);
  EXPECT_NEAR(gapBelow(ceiling).low, 0.085, 1e-9);
  ceiling.residual = 0.015;
  EXPECT_NEAR(gapBelow(ceiling).high, 0.06, 1e-9);
  EXPECT_NEAR(gapBelow(ceiling).low, 0.115, 1e-9);
}

/** A room of 4 m x 3 m with a box 5 cm below the ceiling, which is seen above the box
 * if `is_seen_above`. */
struct BoxRoom {
  BoxRoom(const PlanLoop& box, bool is_seen_above)
  {
    const PlanLoop loop = rectangle(0.01, 0.01, 4.01, 3.01);
    parts.floor = points.slab(loop, 0);
    for (const auto& e : loop.elements)
      parts.walls = joined(parts.walls, points.wall(e, 0, height));
    for (const auto& e : box.elements)
      parts.walls = joined(parts.walls, points.wall(e, 0, height - 0.05));
    parts.ceiling = points.slab(loop, height, [&](double x, double y) {
      return is_seen_above || !box.contains({x, y});
    });
  }

  CellMask open() const
  {
    const CellGrid grid(0.05);
    const CellSet seen(grid, points.view(), parts.ceiling);
    const CellBox all = grown(boxOf(seen), 14);
    const ColumnTable columns(grid, all, points.view(), points.all());
    return aroundSeenCeiling(
        CellMask(seen, all),
        verticalCells(all, grid, columns, slabAt(height), slabAt(0), 2), grid);
  }

  RoomPoints points;
  RoomParts parts;
};

TEST(AroundSeenCeiling, IsACabinetAndNoColumnNorAnythingAsLargeAsARoom)
{
  const PlanLoop box = rectangle(1.61, 1.11, 2.41, 1.91);
  const CellMask open = BoxRoom(box, true).open();
  const CellGrid grid(0.05);
  for (const auto& e : box.elements)
    for (const double share : {0.2, 0.5, 0.8}) {
      const Eigen::Vector2d p = e.pointAt(share * e.length());
      EXPECT_TRUE(open.at(grid.at(p.x(), p.y()))) << p.transpose();
    }
  EXPECT_TRUE(open.at(grid.at(2, 1.5)));
  EXPECT_FALSE(open.at(grid.at(1.4, 1.5)));
  EXPECT_EQ(BoxRoom(box, false).open().count(), 0U);
  EXPECT_EQ(BoxRoom(rectangle(1.01, 0.51, 2.51, 2.01), true).open().count(), 0U);
}

TEST(FitRoom, ACabinetAboveWhichTheCeilingIsSeenIsNoColumn)
{
  for (const bool is_cabinet : {true, false}) {
    const BoxRoom room(rectangle(1.61, 1.11, 2.41, 1.91), is_cabinet);
    std::string problem;
    const PlanRoom plan =
        fitRoom(room.points.view(), evidenceOf(room.points, room.parts), {}, problem);
    EXPECT_EQ(problem, "");
    EXPECT_EQ(plan.columns.size(), is_cabinet ? 0U : 1U);
    EXPECT_EQ(plan.boundary.elements.size(), 4u);
  }
}

TEST(FitRoom, AWardrobeTenCentimetresShortOfTheCeilingIsNoWall)
{
  const WardrobeRoom room(height - 0.1, 0.12);
  RoomEvidence evidence = evidenceOf(room.points, room.parts);
  evidence.walls = joined(evidence.walls, room.box); // as wall growing labels it
  std::string problem;
  const PlanRoom plan = fitRoom(room.points.view(), evidence, {}, problem);
  EXPECT_EQ(problem, "");
  EXPECT_TRUE(plan.columns.empty());
  EXPECT_EQ(plan.boundary.elements.size(), 4u);
  EXPECT_LT(cornerError(plan.boundary, rectangle(0.01, 0.01, 4.01, 3.01)), 0.01);
}

} // namespace

// SPDX-License-Identifier: BSD-3-Clause
#include "room_evidence.h"
#include "sedr_segmentation/src/plan/room_ceilings.h"
#include "sedr_segmentation/src/sheets/sheet_relief.h"

#include <cmath>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

constexpr double width = 5;
constexpr double crown = 2.85;
constexpr double rise = 0.35;

/** Returns the height of a vault along y in a room of 5 m x 4 m. */
double
vaultAt(double x)
{
  return crown - rise * std::pow((x - width / 2) / (width / 2), 2);
}

/** Returns the fitted room; the main ceiling is within 5 cm of the crown. */
PlanRoom
vaultedRoom()
{
  RoomPoints points(0.05, 0.002);
  RoomParts parts;
  parts.floor = points.slab(rectangle(0, 0, width, 4), 0);
  for (const auto& e : rectangle(0, 0, width, 4).elements)
    parts.walls =
        joined(parts.walls,
               points.wall(e, 0, std::min(vaultAt(e.start.x()), vaultAt(e.end.x()))));
  for (double y = 0.025; y < 4; y += 0.05)
    for (double x = 0.025; x < width; x += 0.05) {
      const double z = vaultAt(x);
      (z > crown - 0.05 ? parts.ceiling : parts.details)
          .push_back(points.point(x, y, z));
    }
  return fitted(points, parts);
}

TEST(VaultedRoom, AVaultIsACurveThoughItsPointsWereFoundAsCeilingAndDetails)
{
  const PlanRoom room = vaultedRoom();
  EXPECT_TRUE(room.details.empty());
  ASSERT_TRUE(room.ceiling.curve);
  for (double x = 0.1; x < width - 0.05; x += 0.1)
    for (double y = 0.1; y < 3.95; y += 0.1)
      EXPECT_NEAR(room.ceilingAt({x, y}), vaultAt(x), 0.01) << x << ' ' << y;
}

/** Until the walls are adjusted a room has its ceiling as a relief. */
TEST(GiveCeilings, FacetsThatAreLevelReplaceARelief)
{
  Floorplan plan;
  plan.rooms.emplace_back();
  plan.rooms[0].id = 1;
  plan.rooms[0].boundary = rectangle(0, 0, 6, 4);
  RoomPoints points(0.04, 0.003);
  points.slab(rectangle(0, 0, 4, 4), 2.5);
  points.slab(rectangle(4, 0, 6, 4), 2.2);
  RoomSheet sheet;
  sheet.room = 1;
  for (std::size_t i = 0; i < points.view().size(); ++i)
    sheet.points.push_back(points.view()[i].cast<double>());
  sheet.sheet = surfaceWithin(plan.rooms[0].boundary, sheet.points);
  plan.rooms[0].ceiling = reliefOf(sheet.sheet, 0.15);
  giveCeilings({sheet}, points.view(), {}, 1, plan);
  EXPECT_FALSE(plan.rooms[0].ceiling.curve);
  EXPECT_NEAR(plan.rooms[0].ceilingAt({2, 2}), 2.5, 0.002);
  EXPECT_NEAR(plan.rooms[0].ceilingAt({5, 2}), 2.2, 0.002);
  EXPECT_EQ(plan.rooms[0].details.size(), 1u);
}

} // namespace

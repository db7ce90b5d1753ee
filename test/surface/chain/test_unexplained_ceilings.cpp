// SPDX-License-Identifier: BSD-3-Clause
// Ceilings that were seen above the plan's, and parts of it that may hang below.
#include "seen_rooms.h"

#include <gtest/gtest.h>

#include <cmath>

#include <random>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(UnexplainedCeilings, AreCoffersHoweverSmallThatThePlanDoesNotHave)
{
  // Coffers of 0.2 m2 between ribs of 0.15 m that the plan takes for the ceiling.
  const Floorplan plan{{planned(1, 0, 4)}};
  Cloud cloud = recessedRoom(0);
  for (float x = 0.1F; x < 3.8F; x += 0.6F)
    for (float y = 0.1F; y < 2.8F; y += 0.6F)
      addRectangle({x, y, 2.8F}, {0.45F, 0, 0}, {0, 0.45F, 0}, cloud);
  const auto found = unexplained(cloud, plan);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, WarningKind::CeilingOff);
  EXPECT_NEAR(found[0].values[0], 7 * 5 * 0.45 * 0.45, 2) << "to a cell";
  EXPECT_NEAR(found[0].values[1], 2.8, 1e-3);
}

TEST(UnexplainedCeilings, AreCeilingsThatAreToldOnceAndNotAlongWalls)
{
  const Floorplan plan{{planned(1, 0, 4)}};
  Cloud cloud = recessedRoom(0);
  for (const float y : {0.0F, 2.9F}) // what lies above the ceiling at the walls
    addRectangle({0, y, 2.8F}, {4, 0, 0}, {0, 0.1F, 0}, cloud);
  EXPECT_TRUE(unexplained(cloud, plan).empty());
  Building building = buildingOfTwoRooms();
  for (RoomColumn& column : building.rooms[0].columns)
    if ((building.grid.centre(column.cell) - Eigen::Vector2d(2, 1.5))
            .lpNorm<Eigen::Infinity>() < 0.75)
      column.ceiling = 2.8F;
  addRectangle({1.25F, 0.75F, 2.8F}, {1.5F, 0, 0}, {0, 1.5F, 0}, cloud);
  const auto found = unexplained(cloud, plan, building);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, WarningKind::CeilingOff);
}

TEST(UnexplainedCeilings, AreADeckBetweenJoistsButNoVoidAboveACeiling)
{
  // Joists of 0.1 m each 0.3 m, one in each cell of the building, which are wider.
  const Floorplan plan{{planned(1, 0, 4)}};
  Building building;
  building.grid = CellGrid(0.2);
  Cloud joists = recessedRoom(0);
  addRectangle({0, 0, 2.8F}, {4, 0, 0}, {0, 3, 0}, joists);
  for (float y = 0.05F; y < 2.9F; y += 0.3F)
    addRectangle({0, y, 2.5F}, {4, 0, 0}, {0, 0.1F, 0}, joists);
  const auto found = unexplained(joists, plan, building);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, WarningKind::CeilingOff);
  EXPECT_NEAR(found[0].values[0], 9 * 0.1 * 3.6, 0.1) << "tiles, but for the edge";
  EXPECT_NEAR(found[0].values[1], 2.8, 1e-3);
  for (const float step : {0.05F, 0.15F}) { // of points of ceiling and void
    Cloud seen = recessedRoom(0);
    addRectangle({0, 0, 2.5F}, {4, 0, 0}, {0, 3, 0}, seen, step);
    addRectangle({0, 0, 2.8F}, {4, 0, 0}, {0, 3, 0}, seen, step - 0.01F);
    EXPECT_TRUE(unexplained(seen, plan, building).empty()) << step;
  }
}

TEST(UnexplainedCeilings, AreGapsBetweenJoistsThatNobodySawButNotWhereNoSideLeadsUp)
{
  // Of joists of 0.1 m each 0.4 m the undersides and the lowest of one side are seen.
  const Floorplan plan{{planned(1, 0, 4)}};
  for (const float up : {0.08F, 0.0F}) {
    Cloud cloud = recessedRoom(0);
    for (float y = 0.05F; y < 2.9F; y += 0.4F) {
      addRectangle({0, y, 2.5F}, {4, 0, 0}, {0, 0.1F, 0}, cloud);
      if (up > 0)
        addRectangle({0, y, 2.5F}, {4, 0, 0}, {0, 0, up}, cloud);
    }
    const auto found = unexplained(cloud, plan);
    ASSERT_EQ(found.size(), up > 0 ? 1u : 0u);
    if (up > 0) {
      EXPECT_EQ(found[0].kind, WarningKind::CeilingUnseen);
      EXPECT_NEAR(found[0].values[0], 7 * 0.3 * 3.7, 1.5) << "tiles, but for the edge";
    }
  }
}

TEST(UnexplainedCeilings, AreNoGapsOfSparseAndNoisyOnes)
{
  Floorplan plan{{planned(1, 0, 4)}};
  for (const float step : {0.05F, 0.15F})
    for (const float noise : {0.02F, 0.04F}) {
      std::mt19937 random(1);
      std::normal_distribution<float> off(0, noise);
      Cloud cloud = recessedRoom(0, step);
      const std::size_t walls = cloud.size();
      addRectangle({0, 0, 2.5F}, {4, 0, 0}, {0, 3, 0}, cloud, step);
      for (std::size_t i = walls; i < cloud.size(); ++i)
        cloud[i].z += off(random);
      plan.rooms[0].ceiling.residual = static_cast<double>(noise);
      for (const PlanWarning& warning : unexplained(cloud, plan))
        EXPECT_NE(warning.kind, WarningKind::CeilingUnseen) << step << ' ' << noise;
    }
}

/** @brief A room of 4 m x 3 m x 2.5 m with parts of its ceiling at other heights. */
struct RoomWithParts {
  Floorplan plan{{planned(1, 0, 4)}};
  Cloud cloud;
  float step; ///< of its points, metres

  explicit RoomWithParts(float step_of_points = 0.05F)
      : cloud(recessedRoom(0, step_of_points))
      , step(step_of_points)
  {
    addRectangle({0, 0, 2.5F}, {4, 0, 0}, {0, 3, 0}, cloud, step);
  }

  /** @brief Adds a part of the ceiling.
   * @param low, high of what was seen of its sides, metres */
  void add(float x0, float y0, float x1, float y1, float z, float low, float high)
  {
    plan.rooms[0].details.push_back(detailOf(rectangle(x0, y0, x1, y1), z));
    addRectangle({x0, y0, z}, {x1 - x0, 0, 0}, {0, y1 - y0, 0}, cloud, step);
    for (const float y : {y0, y1})
      addRectangle({x0, y, low}, {x1 - x0, 0, 0}, {0, 0, high - low}, cloud, step);
    for (const float x : {x0, x1})
      addRectangle({x, y0, low}, {0, y1 - y0, 0}, {0, 0, high - low}, cloud, step);
  }

  /** @brief Returns what is told of one kind, such as of what may hang in the room. */
  std::vector<PlanWarning> hanging(WarningKind kind = WarningKind::Hanging) const
  {
    std::vector<PlanWarning> found;
    for (const PlanWarning& warning : unexplained(cloud, plan))
      if (warning.kind == kind)
        found.push_back(warning);
    return found;
  }

  /** @brief Returns what is told of parts of which nothing was seen. */
  std::vector<PlanWarning> unseen() const { return hanging(WarningKind::PartUnseen); }
};

TEST(UnexplainedCeilings, AreIslandsThatHangBelowACeiling)
{
  for (const float step : {0.05F, 0.1F})
    for (const float drop : {0.15F, 0.2F, 0.4F}) {
      const float z = 2.5F - drop;
      RoomWithParts island(step);
      island.add(1, 1, 3, 2, z, z, z + 0.05F);
      const auto found = island.hanging();
      const bool is_between_rows = step > 0.05F && drop < 0.2F;
      ASSERT_EQ(found.size(), is_between_rows ? 0u : 1u)
          << drop << " m, points each " << step << " m";
      if (!is_between_rows) {
        EXPECT_NEAR(found[0].values[0], 2, 1e-6);
        EXPECT_NEAR(found[0].values[1], drop, 1e-6);
        EXPECT_NEAR(found[0].values[2], 0, 5);
      }
      RoomWithParts part(step);
      part.add(1, 1, 3, 2, z, z, 2.5F);
      EXPECT_TRUE(part.hanging().empty()) << drop << " m, points each " << step << " m";
    }
  RoomWithParts island;
  island.add(1, 1, 3, 2, 2.1F, 2.1F, 2.25F);
  ASSERT_EQ(island.hanging().size(), 1u);
  EXPECT_NEAR(island.hanging()[0].values[2], 100 * 0.1 / 0.3, 5)
      << "but for 5 cm at both ends";
}

TEST(UnexplainedCeilings, HangByTheirDropToWhatIsBesideThem)
{
  RoomWithParts room;
  room.add(0.5F, 0.5F, 3.5F, 2.5F, 2.3F, 2.3F, 2.5F);
  room.add(1, 1, 3, 2, 2.05F, 2.05F, 2.1F);
  ASSERT_EQ(room.hanging().size(), 1u);
  EXPECT_NEAR(room.hanging()[0].values[1], 0.25, 1e-6);
}

TEST(UnexplainedCeilings, HangOnceInARoom)
{
  RoomWithParts room;
  for (const float x : {0.5F, 1.5F, 2.5F})
    room.add(x, 0.5F, x + 0.3F, x == 1.5F ? 2.5F : 2, 2.2F, 2.2F, 2.25F);
  const auto found = room.hanging();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].values[0], 0.3 * (2 + 2 * 1.5), 1e-6);
  EXPECT_NEAR((found[0].at - Eigen::Vector2d(1.8, 1.5)).norm(), 0, 1e-6)
      << "a side of the largest";
}

TEST(UnexplainedCeilings, AreNoBeamsSoffitsRibsOrRooflights)
{
  for (const float step : {0.05F, 0.1F})
    for (const float seen : {0.05F, 0.3F}) {
      RoomWithParts beam(step);
      beam.add(1.8F, 0, 2.2F, 3, 2.2F, 2.2F, 2.2F + seen);
      EXPECT_TRUE(beam.hanging().empty());
      RoomWithParts soffit(step);
      soffit.add(0, 2.4F, 4, 3, 2.2F, 2.2F, 2.2F + seen);
      EXPECT_TRUE(soffit.hanging().empty());
      RoomWithParts rooflight(step);
      rooflight.add(1, 1, 3, 2, 2.8F, 2.8F - seen, 2.8F);
      EXPECT_TRUE(rooflight.hanging().empty());
    }
  RoomWithParts ribs; // that end before the walls
  for (float x = 0.5F; x < 3.5F; x += 0.6F)
    ribs.add(x, 0.2F, x + 0.15F, 2.8F, 2.2F, 2.2F, 2.5F);
  EXPECT_TRUE(ribs.hanging().empty());
}

TEST(UnexplainedCeilings, AreRibsThatThePlanDoesNotHaveButNoLampAndNoStrays)
{
  // Two ribs of 0.1 m x 0.2 m below a ceiling that was seen beside them, in each cell.
  const Floorplan plan{{planned(1, 0, 4)}};
  RoomWithParts ribs;
  for (const float y : {0.8F, 2.2F}) {
    addRectangle({0, y, 2.3F}, {4, 0, 0}, {0, 0.1F, 0}, ribs.cloud, 0.02F);
    for (const float side : {0.0F, 0.1F})
      addRectangle({0, y + side, 2.3F}, {4, 0, 0}, {0, 0, 0.2F}, ribs.cloud, 0.02F);
  }
  const auto found = unexplained(ribs.cloud, plan);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].kind, WarningKind::Standing);
  EXPECT_EQ(found[1].kind, WarningKind::Standing);
  EXPECT_NEAR(found[0].values[0] + found[1].values[0], 2 * 4 * (2 * 0.2 + 0.1), 1)
      << "to a cell";
  EXPECT_NEAR(std::abs(found[0].at.y() - found[1].at.y()), 2.2 - 0.8, 0.1);
  RoomWithParts lamp;
  addRectangle({1.8F, 1.3F, 2.4F}, {0.4F, 0, 0}, {0, 0.4F, 0}, lamp.cloud, 0.02F);
  EXPECT_TRUE(unexplained(lamp.cloud, plan).empty());
  RoomWithParts strays; // one a tile and step, as between the edges of two things
  addRectangle({0.5F, 1.5F, 1.9F}, {3, 0, 0}, {0, 0, 0.6F}, strays.cloud, 0.1F);
  EXPECT_TRUE(unexplained(strays.cloud, plan).empty());
}

TEST(UnexplainedCeilings, AreNotHigherPartsThatEndBeforeTheirWall)
{
  RoomWithParts room(0.02F);
  room.plan.rooms[0].details = {detailOf(rectangle(0, 1.6, 4, 3), 2.7)};
  addRectangle({0, 1.6F, 2.7F}, {4, 0, 0}, {0, 0.6F, 0}, room.cloud, 0.02F);
  EXPECT_TRUE(room.unseen().empty());
}

TEST(UnexplainedCeilings, AreLowerPartsOfWhichNothingWasSeen)
{
  RoomWithParts room(0.02F); // from x = 2 m on
  room.plan.rooms[0].details = {detailOf(rectangle(0, 2.6, 4, 3), 2.1)};
  addRectangle({0, 2.6F, 2.1F}, {2, 0, 0}, {0, 0.4F, 0}, room.cloud, 0.02F);
  const auto parts = room.unseen();
  ASSERT_FALSE(parts.empty());
  EXPECT_NEAR(parts[0].values[0], 2 * 0.4, 0.45) << "up to 1.2 m before its end, too";
  EXPECT_NEAR(parts[0].at.x(), 3, 0.2);
}

TEST(UnexplainedCeilings, AreLowerPartsThatEndBeforeTheirWall)
{
  for (const float gap : {0.02F, 0.08F}) { // at the wall at y = 3
    RoomWithParts room(0.02F);
    room.plan.rooms[0].details = {detailOf(rectangle(0, 2.6, 4, 3), 2.1)};
    addRectangle({0, 2.6F, 2.1F}, {4, 0, 0}, {0, 0.4F - gap, 0}, room.cloud, 0.02F);
    const auto parts = room.unseen();
    ASSERT_EQ(parts.size(), gap > 0.05F ? 1u : 0u);
    for (const PlanWarning& warning : parts) {
      EXPECT_NEAR(warning.values[0], 4 * gap, 0.1);
      EXPECT_EQ(sentenceOf(warning).substr(12),
                "m2 of a lower part of its ceiling around (2.0, 3.0) were not seen: "
                "it may end before the wall");
    }
  }
}

} // namespace

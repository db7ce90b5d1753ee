// SPDX-License-Identifier: BSD-3-Clause
#include "subdivided_room.h"

#include "sedr_surface/src/solid/vertex_levels.h"

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** Returns the levels at a vertex of a room. */
VertexLevels
levelsAt(const SubdividedRoom& room, double x, double y)
{
  const PlanSubdivision& plan = room.subdivision;
  for (std::uint32_t v = 0; v < plan.vertices.size(); ++v)
    if ((plan.placeOf(v) - Eigen::Vector2d(x, y)).norm() < 1e-6)
      return {room.layers, plan, v, room.spokes[v]};
  ADD_FAILURE() << "no vertex at " << x << ' ' << y;
  return {};
}

/** Returns the levels in metres. */
std::vector<double>
heightsAt(const SubdividedRoom& room, double x, double y)
{
  std::vector<double> heights;
  const VertexLevels at = levelsAt(room, x, y);
  for (const std::int64_t level : at.levels())
    heights.push_back(static_cast<double>(level) * room.subdivision.grid.unit());
  return heights;
}

void
expectHeights(const std::vector<double>& found, const std::vector<double>& heights)
{
  ASSERT_EQ(found.size(), heights.size());
  for (std::size_t i = 0; i < heights.size(); ++i)
    EXPECT_NEAR(found[i], heights[i], 1e-6);
}

TEST(VertexLevels, AreTheHeightsOfTheSlabsThatEndThere)
{
  const SubdividedRoom room(roomWithSoffit(slabAt(2.25)));
  ASSERT_EQ(room.problem, "");
  expectHeights(heightsAt(room, 0, 0), {0, 2.5});
  expectHeights(heightsAt(room, 0, 3), {0, 2.25});
  expectHeights(heightsAt(room, 0, 2), {0, 2.25, 2.5});
}

TEST(VertexLevels, WithinTheRoomTheFloorGoesOn)
{
  PlanRoom plan = roomOf(rectangle(0, 0, 4, 3), 2.5);
  plan.details = {detailOf(rectangle(1, 1, 3, 2), 2.2)};
  const SubdividedRoom room(plan);
  expectHeights(heightsAt(room, 1, 1), {2.2, 2.5});
}

TEST(VertexLevels, HeightsNearerThanTheSeparationAreOne)
{
  const double separation = solidSeparation(PlanGrid());
  EXPECT_DOUBLE_EQ(separation, 5e-5);
  // A soffit that rises to less than the separation below the ceiling at x = 0.
  for (const double gap : {0.5 * separation, 2 * separation}) {
    const SubdividedRoom room(roomWithSoffit(slabAt(2.5 - gap, -0.05, 0)));
    ASSERT_EQ(room.problem, "");
    EXPECT_EQ(heightsAt(room, 0, 2).size(), gap < separation ? 2u : 3u) << gap;
    EXPECT_EQ(heightsAt(room, 4, 2).size(), 3u);
  }
}

TEST(VertexLevels, SlabsThatCrossHaveOneLevelThere)
{
  // The soffit's plane crosses the ceiling's at x = 2.
  const SubdividedRoom room(roomWithSoffit(slabAt(2.6, -0.05, 0)));
  ASSERT_EQ(room.problem, "");
  ASSERT_FALSE(room.subdivision.crossings.empty());
  const auto& [vertex, slabs] = *room.subdivision.crossings.begin();
  const Eigen::Vector2d place = room.subdivision.placeOf(vertex);
  EXPECT_NEAR(place.x(), 2, 1e-3);
  const VertexLevels levels = levelsAt(room, place.x(), place.y());
  EXPECT_EQ(levels.levelOf(slabs.first), levels.levelOf(slabs.second));
}

TEST(TouchesItself, WhereTwoPartsMeetInALineOnly)
{
  const SolidSpan nothing;
  const SolidSpan room{0, 25};
  EXPECT_FALSE(touchesItself({room, nothing}));
  EXPECT_FALSE(touchesItself({room, room, nothing, nothing}));
  EXPECT_TRUE(touchesItself({room, nothing, room, nothing}));
}

TEST(TouchesItself, BelowWhatJoinsTwoPartsToo)
{
  const SolidSpan nothing;
  const SolidSpan room{0, 25};
  EXPECT_TRUE(touchesItself({room, {10, 20}, room, nothing}));
  EXPECT_FALSE(touchesItself({room, room, {10, 20}, nothing}));
}

TEST(TouchesItself, WhereOnePartEndsAtTheHeightAtWhichAnotherBegins)
{
  const SolidSpan nothing;
  EXPECT_FALSE(touchesItself({{0, 10}, {5, 20}, nothing}));
  EXPECT_TRUE(touchesItself({{0, 10}, {10, 20}, nothing}));
  EXPECT_TRUE(touchesItself({{0, 10}, nothing, {10, 20}, nothing}));
}

} // namespace

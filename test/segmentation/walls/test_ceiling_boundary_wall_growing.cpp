// SPDX-License-Identifier: BSD-3-Clause
#include "wall_growing_scenes.h"

namespace {

using namespace wall_growing;

TEST(CeilingBoundaryWallGrowing, WallsAreExactlyThePointsWithinTheDistance)
{
  Scene scene;
  const auto ceiling = scene.slab(0, 2, 0, 2, 2.5f);
  const auto at_distance = scene.pole(2.125f, 1, 0, 2);
  scene.pole(std::nextafter(2.125f, 3.f), 1, 0, 2);
  const auto at_corner = scene.pole(2.09375f, 2.0625f, 0, 2); // 0.1127 from the corner
  scene.pole(2.09375f, 2.09375f, 0, 2);                       // 0.1326
  scene.pole(1, 1, 0, 2);                                     // amid the room
  Growing growing = growingOn(scene, ceiling);
  growing.setDistanceThreshold(0.125);
  EXPECT_EQ(wallsOf(growing), united(at_distance, at_corner));
  EXPECT_EQ(growing.getWallIndices(), united(at_distance, at_corner));
}

TEST(CeilingBoundaryWallGrowing, WallsAreThoseOfASearchOverAllSeeds)
{
  Scene scene = irregularCeiling(3);
  const auto ceiling = allOf(scene);
  std::mt19937 random(7);
  std::uniform_real_distribution<float> coordinate(-1.f, 4.f);
  for (int i = 0; i < 20000; ++i)
    scene.add(coordinate(random), coordinate(random), coordinate(random));
  for (const double distance : {0.001, 0.05, 0.1, 0.7}) {
    Growing growing = growingOn(scene, ceiling);
    growing.setDistanceThreshold(distance);
    const auto walls = wallsOf(growing);

    pcl::Indices expected;
    for (std::size_t i = ceiling.size(); i < scene.cloud->size(); ++i) {
      const auto p = (*scene.cloud)[i].getVector3fMap().head<2>().cast<double>();
      const auto isNear = [&](pcl::index_t seed) {
        const auto& s = (*scene.cloud)[static_cast<std::size_t>(seed)];
        return (s.getVector3fMap().head<2>().cast<double>() - p).norm() <= distance;
      };
      const auto& seeds = growing.getBoundaryIndices();
      if (std::any_of(seeds.begin(), seeds.end(), isNear))
        expected.push_back(static_cast<pcl::index_t>(i));
    }
    EXPECT_EQ(walls, expected) << distance << " m";
  }
}

TEST(CeilingBoundaryWallGrowing, CeilingAndFloorPointsAreNeverWalls)
{
  Scene scene;
  const auto ceiling = scene.slab(0, 2, 0, 2, 2.5f);
  const auto floor = scene.slab(0, 2, 0, 2, 0.f);
  const auto wall = scene.pole(2, 1, 0.5f, 2);
  Growing growing = growingOn(scene, ceiling);
  growing.setFloorIndices(indexList(floor));
  EXPECT_EQ(wallsOf(growing), wall);
  EXPECT_TRUE(growing.getFloorBoundaryIndices().empty());
}

TEST(CeilingBoundaryWallGrowing, SliceDividesSeedsOfCeilingAndScopeFromThoseOfTheFloor)
{
  const SoffitRoom room;
  Growing growing = room.growing();
  const auto walls =
      united(united(room.wall_above, room.wall_below), room.by_riser_above);
  EXPECT_EQ(wallsOf(growing), united(walls, room.soffit));
  EXPECT_EQ(growing.getWallIndices(), walls);

  // The soffit's edge is a boundary of the ceiling, but not of scope or floor.
  EXPECT_EQ(growing.getBoundaryIndices().size(), 4u * 48u);
  EXPECT_EQ(growing.getFloorBoundaryIndices().size(), 2u * 48u + 2u * 64u);
  for (const auto i : growing.getScopeBoundaryIndices()) {
    const auto& p = (*room.cloud)[static_cast<std::size_t>(i)];
    EXPECT_TRUE(p.x == 0 || p.x == 4 || p.y == 0 || p.y == 3) << p;
  }
  EXPECT_GE(growing.getScopeBoundaryIndices().size(), 2u * 48u + 2u * 64u);
}

TEST(CeilingBoundaryWallGrowing, WithoutSliceTheCeilingAloneSeedsAndDetailsHaveNoEffect)
{
  const SoffitRoom room;
  Growing growing = room.growing();
  growing.setSliceHeight(std::numeric_limits<double>::quiet_NaN());
  auto expected = united(room.by_riser_above, room.by_riser_below);
  for (const auto i : room.soffit)
    if ((*room.cloud)[static_cast<std::size_t>(i)].x <= 3 + step)
      expected.push_back(i);
  EXPECT_EQ(wallsOf(growing), united(expected, {}));
  EXPECT_TRUE(growing.getScopeBoundaryIndices().empty());
  EXPECT_TRUE(growing.getFloorBoundaryIndices().empty());
}

TEST(CeilingBoundaryWallGrowing, DetailsJoinTheWallsThoughTheyAreNoCandidates)
{
  const SoffitRoom room;
  Growing growing = room.growing();
  growing.setIndices(indexList(room.wall_below));
  EXPECT_EQ(wallsOf(growing), united(room.wall_below, room.soffit));
}

TEST(CeilingBoundaryWallGrowing, FarFromTheOriginTheRoomIsTheSame)
{
  Scene near_by, far_away;
  const float x = 10240, y = -10240; // floats there are 1 / 1024 m apart
  const auto ceiling = near_by.slab(0, 2, 0, 2, 2.5f);
  near_by.pole(2.0625f, 1, 0, 2);
  near_by.pole(2.1875f, 1, 0, 2);
  for (const auto& p : *near_by.cloud)
    far_away.add(p.x + x, p.y + y, p.z);
  far_away.add(-1e15f, 1e15f, 0); // too far for a 32-bit cell of 0.1 m
  Growing growing = growingOn(near_by, ceiling);
  const auto walls = wallsOf(growing);
  growing.setInputCloud(far_away.cloud);
  EXPECT_EQ(wallsOf(growing), walls);
}

TEST(CeilingBoundaryWallGrowing, BadInputIsRefusedWithAReasonAndClearsTheResult)
{
  const SoffitRoom room;
  const auto refusesWith = [&](auto change, const char* word) {
    Growing growing = room.growing();
    change(growing);
    pcl::PointIndices walls;
    walls.indices = {1, 2, 3};
    EXPECT_FALSE(growing.segment(walls)) << word;
    EXPECT_TRUE(walls.indices.empty()) << word;
    EXPECT_TRUE(growing.getBoundaryIndices().empty()) << word;
    EXPECT_NE(growing.getErrorMessage().find(word), std::string::npos)
        << growing.getErrorMessage();
  };
  refusesWith([](Growing& g) { g.setInputCloud(pcl::make_shared<Cloud>()); },
              "0 points");
  refusesWith([](Growing& g) { g.setFloorIndices(indexList({99999})); }, "index 99999");
  refusesWith([](Growing& g) { g.setCeilingIndices(nullptr); }, "there are 0");
  refusesWith(
      [](Growing& g) {
        g.setCeilingIndices(indexList({0, 1, 1}));
      },
      "there are 2");
  refusesWith([](Growing& g) { g.setFloorIndices(indexList()); }, "floor");
  refusesWith([](Growing& g) { g.setSliceHeight(HUGE_VAL); }, "slice");
}

} // namespace

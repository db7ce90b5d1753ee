// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/parting/walked_floors.h"

#include "parted_scenes.h"

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(StandOnFloor, IsSoOnAFloorAndOnAGalleryButNotOnFurniture)
{
  forBothTurns([](AirScene& scene) {
    addRoomWithCupboards(scene, 2.01);
    scene.slab(4.05, 0.05, 6.05, 2.05, 2.01); // a gallery
    const SceneAir air(scene);
    const std::vector<std::uint8_t> is_on_floor = standOnFloor(air.gaps, 0.6);
    EXPECT_EQ(is_on_floor[air.at(4.5, 4, 1)], 1);
    EXPECT_EQ(is_on_floor[air.at(5, 1, 3)], 1);
    EXPECT_EQ(is_on_floor[air.at(5, 1, 1)], 1);
    EXPECT_EQ(is_on_floor[air.at(1.5, 1, 3)], 0);
  });
}

TEST(StandOnFloor, IsNotSoOnFurnitureAboveAnotherStorey)
{
  forBothTurns([](AirScene& scene) {
    scene.slab(0.05, 0.05, 6.05, 5.05, 0.01);
    scene.slab(0.05, 0.05, 6.05, 5.05, 2.51);
    scene.sides(0.05, 0.05, 6.05, 5.05, 0.01, 2.51);
    scene.slab(3.05, 0.05, 6.05, 5.05, 2.81); // the cupboards hide the floor
    scene.slab(0.05, 2.05, 3.05, 5.05, 2.81);
    scene.slab(0.05, 0.05, 6.05, 5.05, 7.11);
    scene.sides(0.05, 0.05, 6.05, 5.05, 2.81, 7.11);
    scene.slab(0.05, 0.05, 3.05, 2.05, 4.11);
    scene.wall(3.05, 0.05, 3.05, 2.05, 2.81, 4.11);
    scene.wall(0.05, 2.05, 3.05, 2.05, 2.81, 4.11);
    const SceneAir air(scene);
    const std::vector<std::uint8_t> is_on_floor = standOnFloor(air.gaps, 0.6);
    EXPECT_EQ(is_on_floor[air.at(4.5, 4, 1)], 1);
    EXPECT_EQ(is_on_floor[air.at(4.5, 4, 4)], 1);
    EXPECT_EQ(is_on_floor[air.at(1.5, 1, 6)], 0);
  });
}

TEST(StandOnFloor, IsSoOnTreadsThatLeadToIt)
{
  AirScene scene; // a stage up to which stairs lead
  scene.room(0.05, 0.05, 8.05, 5.05, 0.01, 4.31);
  scene.slab(5.05, 0.05, 8.05, 5.05, 1.51);
  for (int k = 1; k < 8; ++k)
    scene.slab(5.05 - 0.3 * k, 0.05, 5.35 - 0.3 * k, 1.05, 1.51 - 0.19 * k);
  const SceneAir air(scene);
  const std::vector<std::uint8_t> is_on_floor = standOnFloor(air.gaps, 0.6);
  EXPECT_EQ(is_on_floor[air.at(7, 3, 3)], 1);
  EXPECT_EQ(is_on_floor[air.at(2, 3, 3)], 1);
}

} // namespace

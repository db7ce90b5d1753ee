// SPDX-License-Identifier: BSD-3-Clause
#include "building_scene.h"

#include <gtest/gtest.h>

#include <tuple>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(MirrorImages, AreAsHighAsTheRoomAboveAndBelowASingleSurface)
{
  for (const auto& [low, high, rooms] :
       {std::tuple(-2.49, 0.01, 1u), std::tuple(-2.51, -0.01, 1u),
        std::tuple(-2.57, -0.07, 2u), std::tuple(-2.69, -0.19, 2u), // below a slab
        std::tuple(-2.79, 0.01, 2u)}) {                             // higher
    AirScene scene;
    scene.room(0.05, 0.05, 4.05, 3.05, 0.01, 2.51);
    scene.room(0.05, 0.05, 4.05, 3.05, low, high);
    const Found found(scene);
    ASSERT_EQ(found.building.rooms.size(), rooms) << low;
    EXPECT_NE(found.roomAt(2, 1.5, 1), 0u) << low;
    if (rooms == 1) {
      EXPECT_EQ(found.building.left_out.at(0).kind, LeftOutKind::Mirror);
    }
  }
}

TEST(MirrorImages, MayHaveTheirFurnitureUpsideDown)
{
  AirScene scene;
  scene.points.slab(scene.loop(0.05, 0.05, 4.05, 3.05), 0.01,
                    [](double x, double y) { return x > 1 || y > 2; }); // beside a desk
  for (const double z : {-2.49, 2.51})
    scene.slab(0.05, 0.05, 4.05, 3.05, z);
  for (const double z : {-0.69, 0.71})
    scene.slab(0.05, 0.05, 1.05, 2.05, z);
  scene.slab(3.05, 0.05, 3.45, 0.45, 0.17); // a carton, its image too sparse
  scene.sides(0.05, 0.05, 4.05, 3.05, -2.49, 2.51);
  const Found found(scene);
  ASSERT_EQ(found.building.rooms.size(), 1u);
  EXPECT_NEAR(found.building.rooms[0].floor, 0.01, 0.06);
  EXPECT_EQ(found.building.left_out.at(0).kind, LeftOutKind::Mirror);
}

} // namespace

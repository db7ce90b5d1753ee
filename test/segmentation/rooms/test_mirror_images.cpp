// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/rooms/reflections.h"
#include "sedr_segmentation/src/rooms/room_description.h"

#include "building_scene.h"

#include "segmentation/parting/parted_scenes.h"

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** Whether the air between two heights below a room of 2.5 m is its mirror image. */
bool
isImage(double low, double high)
{
  AirScene scene;
  scene.room(0.05, 0.05, 4.05, 3.05, 0.01, 2.51);
  scene.room(0.05, 0.05, 4.05, 3.05, low, high);
  const Parted air(scene);
  std::vector<double> floors;
  for (const BuildingRoom& room : describeRooms(air.gaps, air.parted))
    floors.push_back(room.floor);
  const auto is_image = mirrorImages(air.gaps, air.parted, floors);
  EXPECT_EQ(is_image.at(static_cast<std::size_t>(air.roomAt(2, 1.5, 1))), 0);
  return is_image.at(static_cast<std::size_t>(air.roomAt(2, 1.5, -1))) != 0;
}

TEST(MirrorImages, AreWhatIsAsHighAsTheRoomAboveBelowASingleSurface)
{
  EXPECT_TRUE(isImage(-2.49, 0.01));
}

TEST(MirrorImages, AreNotTheRoomsBelowASlab)
{
  EXPECT_FALSE(isImage(-2.69, -0.19));
}

TEST(MirrorImages, AreNotRoomsOfAnotherHeight)
{
  EXPECT_FALSE(isImage(-2.79, 0.01));
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
  scene.sides(0.05, 0.05, 4.05, 3.05, -2.49, 2.51);
  const Found found(scene);
  ASSERT_EQ(found.building.rooms.size(), 1u);
  EXPECT_NEAR(found.building.rooms[0].floor, 0.01, 0.06);
  EXPECT_EQ(found.building.left_out.at(0).kind, LeftOutKind::Mirror);
}

} // namespace

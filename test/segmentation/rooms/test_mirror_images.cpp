// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/rooms/reflections.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;

constexpr double surface = 0.1;

/** A part of a room with 10 x 10 profiles. */
BuildingRoom
part(float floor, float ceiling)
{
  BuildingRoom room;
  room.floor = floor;
  for (int x = 0; x < 10; ++x)
    for (int y = 0; y < 10; ++y)
      room.columns.push_back({{x, y}, floor, ceiling, true, true, true});
  return room;
}

TEST(MirrorImages, AreWhatIsAsHighAsTheRoomAboveBelowASingleSurface)
{
  EXPECT_EQ(mirrorImages({part(0, 2.5F), part(-2.55F, -0.05F)}, surface),
            (std::vector<std::uint8_t>{0, 1}));
  EXPECT_EQ(mirrorImages({part(-2.55F, -0.05F), part(0, 2.5F)}, surface),
            (std::vector<std::uint8_t>{1, 0}))
      << "in whatever order";
}

TEST(MirrorImages, AreNotTheRoomsBelowASlab)
{
  EXPECT_EQ(mirrorImages({part(0, 2.5F), part(-2.7F, -0.2F)}, surface),
            (std::vector<std::uint8_t>{0, 0}));
}

TEST(MirrorImages, AreNotRoomsOfAnotherHeight)
{
  EXPECT_EQ(mirrorImages({part(0, 2.5F), part(-2.85F, -0.05F)}, surface),
            (std::vector<std::uint8_t>{0, 0}));
}

TEST(MirrorImages, MayHaveTheirFurnitureUpsideDown)
{
  BuildingRoom room = part(0, 2.5F);
  BuildingRoom image = part(-2.55F, -0.05F);
  for (std::size_t k = 0; k < 15; ++k) { // a desk
    room.columns[k].floor = 0.7F;
    image.columns[k].ceiling = -0.75F;
  }
  EXPECT_EQ(mirrorImages({room, image}, surface), (std::vector<std::uint8_t>{0, 1}));
}

TEST(MirrorImages, OfNothingAreNone)
{
  EXPECT_TRUE(mirrorImages({}, surface).empty());
}

} // namespace

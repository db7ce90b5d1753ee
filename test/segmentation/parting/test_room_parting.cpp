// SPDX-License-Identifier: BSD-3-Clause
#include "parted_scenes.h"
#include "segmentation/air/stairs_scene.h"

#include <tuple>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** Adds a hall and a chamber behind a wall of 80 cm, as in old buildings, with a door
 * of 1 m. */
void
addRoomsBehindAThickWall(AirScene& scene)
{
  const double x = 6.05;
  for (const auto& [x0, x1, y1, high] :
       {std::tuple(0.05, x, 8.05, 4.51), std::tuple(x + 0.8, x + 3.8, 4.05, 2.61)}) {
    scene.slabs(x0, 0.05, x1, y1, 0.01, high);
    for (const double y : {0.05, y1})
      scene.wall(x0, y, x1, y, 0.01, high);
  }
  scene.wall(0.05, 0.05, 0.05, 8.05, 0.01, 4.51);
  scene.wall(x + 3.8, 0.05, x + 3.8, 4.05, 0.01, 2.61);
  for (const double z : {0.01, 2.11})
    scene.slab(x, 1.05, x + 0.8, 2.05, z);
  for (const double side : {1.05, 2.05})
    scene.wall(x, side, x + 0.8, side, 0.01, 2.11);
  for (const auto& [face, y1, high] :
       {std::tuple(x, 8.05, 4.51), std::tuple(x + 0.8, 4.05, 2.61)}) {
    scene.wall(face, 0.05, face, 1.05, 0.01, high);
    scene.wall(face, 2.05, face, y1, 0.01, high);
    scene.wall(face, 1.05, face, 2.05, 2.11, high);
  }
}

TEST(PartRooms, ADoorThroughAThickWallPartsTwoRooms)
{
  for (const double degrees : {0.0, 15.0, 23.0, 30.0}) {
    SCOPED_TRACE(degrees);
    AirScene scene(degrees);
    addRoomsBehindAThickWall(scene);
    EXPECT_EQ(Parted(scene).rooms(), 2u);
  }
}

/** Adds the same rooms, 4 m deep, with two equal openings beside a pier of 40 cm. */
void
addRoomsWithPier(AirScene& scene, double width, double head)
{
  for (const auto& [x0, x1] : {std::pair(0.05, 4.05), std::pair(4.15, 8.15)}) {
    scene.slabs(x0, 0.05, x1, 6.05, 0.01, 2.91);
    for (const double y : {0.05, 6.05})
      scene.wall(x0, y, x1, y, 0.01, 2.91);
  }
  for (const double x : {0.05, 8.15})
    scene.wall(x, 0.05, x, 6.05, 0.01, 2.91);
  const double from = 3.05 - 0.2 - width;
  const double to = 3.05 + 0.2 + width;
  scene.partition(4.05, 0.05, 3.05, 0.01, 2.91, {from, 2.85, head});
  scene.partition(4.05, 3.05, 6.05, 0.01, 2.91, {3.25, to, head});
}

TEST(PartRooms, AColumnInAWideOpeningBelowABeamPartsNothing)
{
  forBothTurns([](AirScene& scene) {
    addRoomsWithPier(scene, 2.7, 2.51);
    EXPECT_EQ(Parted(scene).rooms(), 1u);
  });
}

TEST(PartRooms, TwoDoorsSideBySidePartTwoRooms)
{
  forBothTurns([](AirScene& scene) {
    addRoomsWithPier(scene, 0.9, 2.11);
    EXPECT_EQ(Parted(scene).rooms(), 2u);
  });
}

TEST(PartRooms, AsHighADoorPartsASmallRoomFromAHallWhoseOutlineItKeeps)
{
  forBothTurns([](AirScene& scene) {
    scene.slabs(0.05, 0.05, 6.05, 6.05, 0.01, 2.51);
    scene.slabs(6.15, 0.05, 9.15, 3.05, 0.01, 2.51);
    scene.wall(0.05, 0.05, 9.15, 0.05, 0.01, 2.51);
    scene.wall(6.15, 3.05, 9.15, 3.05, 0.01, 2.51);
    scene.wall(9.15, 0.05, 9.15, 3.05, 0.01, 2.51);
    scene.wall(0.05, 0.05, 0.05, 6.05, 0.01, 2.51);
    scene.wall(0.05, 6.05, 6.05, 6.05, 0.01, 2.51);
    scene.wall(6.05, 3.05, 6.05, 6.05, 0.01, 2.51);
    scene.partition(6.05, 0.05, 3.05, 0.01, 2.51, {1.05, 1.95, 2.51});
    const Parted air(scene);
    EXPECT_EQ(air.rooms(), 2u);
    for (const auto& [x, y] : {std::pair(7.0, 0.4), std::pair(8.8, 0.4),
                               std::pair(8.8, 2.7), std::pair(7.0, 2.7)})
      EXPECT_EQ(air.roomAt(x, y), 1) << x << ' ' << y;
  });
}

TEST(PartRooms, AWallOfWhichLittleIsLeftJoins)
{
  forBothTurns([](AirScene& scene) {
    addTwoRooms(scene, {0.35, 2.75, 2.51});
    EXPECT_EQ(Parted(scene).rooms(), 1u);
  });
}

TEST(PartRooms, TheAirOnAGalleryIsNotThatBelowIt)
{
  forBothTurns([](AirScene& scene) {
    scene.room(0.05, 0.05, 12.05, 6.05, 0.01, 5.51);
    scene.slabs(8.05, 0.05, 12.05, 6.05, 2.51, 2.81);
    scene.wall(8.05, 0.05, 8.05, 6.05, 2.51, 2.81);
    const Parted air(scene);
    EXPECT_NE(air.roomAt(10, 3, 4), air.roomAt(10, 3, 1));
    EXPECT_NE(air.roomAt(10, 3, 4), air.roomAt(4, 3, 1)) << "nor that of the hall";
  });
}

TEST(PartRooms, ASmallClosetIsNotOfTheRoomAboveItIntoWhichAShaftLeads)
{
  forBothTurns([](AirScene& scene) {
    scene.slabs(0.05, 0.05, 1.05, 0.85, 0.01, 2.01);
    for (const double x : {0.05, 1.05})
      scene.wall(x, 0.05, x, 0.85, 0.01, 2.01);
    scene.wall(0.05, 0.05, 1.05, 0.05, 0.01, 2.01);
    scene.wall(0.05, 0.85, 0.35, 0.85, 0.01, 2.01);
    scene.wall(0.75, 0.85, 1.05, 0.85, 0.01, 2.01);
    scene.slab(0.35, 0.85, 0.75, 1.15, 0.01);
    for (const double x : {0.35, 0.75})
      scene.wall(x, 0.85, x, 1.15, 0.01, 2.81);
    scene.wall(0.35, 1.15, 0.75, 1.15, 0.01, 2.81);
    scene.slab(0.35, 0.85, 0.75, 1.15, 4.51);
    scene.slab(0.05, 0.05, 6.05, 0.85, 2.81);
    scene.slab(0.05, 0.85, 0.35, 1.15, 2.81);
    scene.slab(0.75, 0.85, 6.05, 1.15, 2.81);
    scene.slab(0.05, 1.15, 6.05, 5.05, 2.81);
    scene.slab(0.05, 0.05, 6.05, 5.05, 5.31);
    scene.sides(0.05, 0.05, 6.05, 5.05, 2.81, 5.31);
    const Parted air(scene);
    const int upper = air.roomAt(4, 3, 4);
    EXPECT_EQ(air.roomAt(0.5, 0.5, 4), upper) << "above the closet";
    EXPECT_NE(air.roomAt(0.5, 0.5, 1), upper);
    EXPECT_NE(air.roomAt(0.5, 0.5, 1), -1) << "nor lost";
  });
}

TEST(PartRooms, AStairwellPartsNothingOfTheStoreyAboveAndIsNoneOfTheOneBelow)
{
  forBothTurns([](AirScene& scene) {
    addStoreysWithStairs(scene);
    const Parted air(scene);
    EXPECT_EQ(air.rooms(), 2u);
    const int upper = air.roomAt(2, 1, 4);
    EXPECT_NE(air.roomAt(2, 1, 1), upper);
    EXPECT_EQ(air.roomAt(2, 6.5, 4), upper) << "behind the shaft";
    EXPECT_EQ(air.roomAt(1.45, 3.5, 4), upper) << "beside it";
    EXPECT_EQ(air.roomAt(0.55, 3.5, 4), upper) << "over the stairs";
    ASSERT_EQ(air.parted.openings.size(), 1u);
    const RoomOpening& flight = air.parted.openings.front();
    EXPECT_NEAR((flight.middle - scene.place(0.55, 1.95)).norm(), 0, 0.3);
    EXPECT_NEAR(flight.width, 1, 0.3);
  });
}

TEST(PartRooms, ALoftOpenOnTwoSidesTakesNoFloorFromTheHallBelow)
{
  forBothTurns([](AirScene& scene) {
    scene.room(0.05, 0.05, 6.05, 5.05, 0.01, 5.01);
    scene.slabs(0.05, 0.05, 2.05, 2.05, 2.21, 2.41);
    const Parted air(scene);
    EXPECT_EQ(air.roomAt(1, 1, 1), air.roomAt(4, 3, 1)) << "below the loft";
  });
}

TEST(PartRooms, ABeamAcrossARoomPartsNothing)
{
  for (const double depth : {0.2, 0.4, 0.6})
    forBothTurns([&](AirScene& scene) {
      scene.room(0.05, 0.05, 8.05, 4.05, 0.01, 2.81);
      scene.hanging(3.85, 0.05, 4.15, 4.05, 2.81 - depth, 2.81);
      EXPECT_EQ(Parted(scene).rooms(), 1u) << depth;
    });
}

TEST(PartRooms, NorDoesOneOnColumns)
{
  forBothTurns([](AirScene& scene) {
    scene.room(0.05, 0.05, 24.05, 6.05, 0.01, 2.81);
    scene.hanging(11.85, 0.05, 12.25, 6.05, 2.21, 2.81);
    for (const double y : {1.45, 4.25})
      scene.sides(11.85, y, 12.25, y + 0.4, 0.01, 2.21);
    EXPECT_EQ(Parted(scene).rooms(), 1u);
  });
}

TEST(PartRooms, APierBetweenTwoWaysIsAWall)
{
  forBothTurns([](AirScene& scene) {
    scene.room(0.05, 0.05, 2.95, 8.15, 0.01, 2.61);
    for (const auto& [from, to] : {std::pair(0.05, 0.25), {1.15, 1.75}, {2.75, 2.95}})
      scene.sides(from, 4.05, to, 4.15, 0.01, 2.61);
    EXPECT_EQ(Parted(scene).rooms(), 2u);
  });
}

TEST(PartRooms, NorDoRibs)
{
  forBothTurns([](AirScene& scene) {
    scene.room(0.05, 0.05, 8.05, 4.05, 0.01, 2.81);
    for (double x = 0.85; x < 8; x += 1)
      scene.hanging(x, 0.05, x + 0.2, 4.05, 2.51, 2.81);
    EXPECT_EQ(Parted(scene).rooms(), 1u);
  });
}

TEST(PartRooms, NorDoLampsThatHangInARow)
{
  forBothTurns([](AirScene& scene) {
    scene.room(0.05, 0.05, 8.05, 4.05, 0.01, 2.81);
    for (double y = 0.35; y < 3.5; y += 0.9)
      scene.slab(4, y, 4.2, y + 0.6, 2.21);
    scene.slab(6, 2, 6.1, 2.1, 1.51); // one on a long cord
    EXPECT_EQ(Parted(scene).rooms(), 1u);
  });
}

/** Adds a hall of 8 m x 6 m with a corridor of 6 m in the middle of its side. */
void
addHallWithCorridor(AirScene& scene, double width, double lintel)
{
  const double low = 3.05 - width / 2;
  const double high = 3.05 + width / 2;
  scene.slabs(0.05, 0.05, 8.05, 6.05, 0.01, 2.81);
  scene.slabs(8.05, low, 14.05, high, 0.01, 2.81);
  for (const double y : {0.05, 6.05})
    scene.wall(0.05, y, 8.05, y, 0.01, 2.81);
  for (const double y : {low, high})
    scene.wall(8.05, y, 14.05, y, 0.01, 2.81);
  scene.wall(0.05, 0.05, 0.05, 6.05, 0.01, 2.81);
  scene.wall(14.05, low, 14.05, high, 0.01, 2.81);
  scene.wall(8.05, 0.05, 8.05, low, 0.01, 2.81);
  scene.wall(8.05, high, 8.05, 6.05, 0.01, 2.81);
  if (lintel > 0)
    scene.hanging(8.05, low, 8.25, high, 2.81 - lintel, 2.81);
}

TEST(PartRooms, ACorridorThatIsOpenToAHallAtItsFullWidthIsOfIt)
{
  for (const double width : {1.4, 2.0, 3.0})
    forBothTurns([&](AirScene& scene) {
      addHallWithCorridor(scene, width, 0);
      EXPECT_EQ(Parted(scene).rooms(), 1u) << width;
    });
}

TEST(PartRooms, BelowALintelItIsARoomOfItsOwn)
{
  for (const auto& [width, lintel] :
       {std::pair(1.4, 0.4), std::pair(2.0, 0.5), std::pair(3.0, 0.7)})
    forBothTurns([&, width = width, lintel = lintel](AirScene& scene) {
      AirScene higher = scene;
      addHallWithCorridor(scene, width, lintel);
      const Parted air(scene);
      EXPECT_EQ(air.rooms(), 2u) << width;
      EXPECT_NE(air.roomAt(4, 3), air.roomAt(12, 3)) << width;
      addHallWithCorridor(higher, width, 0.11);
      EXPECT_EQ(Parted(higher).rooms(), 1u) << width;
    });
}

TEST(PartRooms, ANookBelowABeamWithADoorToTheNextRoomIsOfTheHallItOpensTo)
{
  forBothTurns([](AirScene& scene) {
    addTwoRooms(scene, {1.05, 1.95, 2.11}); // the door from the second room
    // Before the door 1 m of the hall is 2.4 m wide, below a beam at its mouth.
    for (const auto& [from, to] : {std::pair(0.05, 0.35), std::pair(2.75, 3.05)})
      scene.sides(3.05, from, 4.05, to, 0.01, 2.51);
    scene.hanging(3.05, 0.35, 3.15, 2.75, 2.21, 2.51);
    const Parted air(scene);
    EXPECT_EQ(air.rooms(), 2u);
    EXPECT_EQ(air.roomAt(3.5, 1.5), air.roomAt(2, 1.5));
    EXPECT_NE(air.roomAt(3.5, 1.5), air.roomAt(5.5, 1.5));
  });
}

TEST(PartRooms, ColumnsPartNothing)
{
  forBothTurns([](AirScene& scene) {
    scene.room(0.05, 0.05, 12.05, 9.05, 0.01, 2.81);
    for (double x = 2.85; x < 11; x += 3)
      for (double y = 2.85; y < 8; y += 3)
        scene.sides(x, y, x + 0.4, y + 0.4, 0.01, 2.81);
    EXPECT_EQ(Parted(scene).rooms(), 1u);
  });
}

TEST(PartRooms, AStepInFloorOrCeilingPartsNothing)
{
  forBothTurns([](AirScene& scene) {
    scene.slab(0.05, 0.05, 4.05, 4.05, 0.01);
    scene.slab(4.05, 0.05, 8.05, 4.05, 0.51);
    scene.wall(4.05, 0.05, 4.05, 4.05, 0.01, 0.51);
    scene.slab(0.05, 0.05, 3.05, 4.05, 2.51);
    scene.slab(3.05, 0.05, 8.05, 4.05, 3.21);
    scene.wall(3.05, 0.05, 3.05, 4.05, 2.51, 3.21);
    scene.sides(0.05, 0.05, 8.05, 4.05, 0.01, 3.21);
    EXPECT_EQ(Parted(scene).rooms(), 1u);
  });
}

/** A corridor of 8 m x 1 m beside a room of 3 m x 3 m, with an opening up to the
 * ceiling at the end of the room's wall. */
void
addCorridor(AirScene& scene, double opening)
{
  scene.slabs(0.05, 0.05, 1.05, 8.05, 0.01, 2.51);
  scene.slabs(1.15, 5.05, 4.15, 8.05, 0.01, 2.51);
  scene.wall(0.05, 0.05, 1.05, 0.05, 0.01, 2.51);
  scene.wall(0.05, 8.05, 4.15, 8.05, 0.01, 2.51);
  scene.wall(0.05, 0.05, 0.05, 8.05, 0.01, 2.51);
  scene.wall(1.05, 0.05, 1.05, 5.05, 0.01, 2.51);
  scene.wall(1.05, 5.05, 4.15, 5.05, 0.01, 2.51);
  scene.wall(4.15, 5.05, 4.15, 8.05, 0.01, 2.51);
  scene.partition(1.05, 5.05, 8.05, 0.01, 2.51, {5.35, 5.35 + opening, 2.51});
}

TEST(PartRooms, ADoorwayAsWideAsTheCorridorPartsThem)
{
  forBothTurns([](AirScene& scene) {
    addCorridor(scene, 1.0);
    const Parted air(scene);
    EXPECT_EQ(air.rooms(), 2u);
    EXPECT_EQ(air.roomAt(0.55, 1), air.roomAt(0.55, 7.5)) << "the corridor stays one";
    EXPECT_NE(air.roomAt(0.55, 5.85), air.roomAt(2.5, 6.5));
  });
}

TEST(PartRooms, AnOpeningWiderThanALeafPartsNothingWithoutALintel)
{
  forBothTurns([](AirScene& scene) {
    addCorridor(scene, 2.0);
    EXPECT_EQ(Parted(scene).rooms(), 1u);
  });
}

TEST(PartRooms, TheAirOnFurnitureIsOfTheRoomHoweverHighItIs)
{
  for (const double height : {1.51, 2.01, 2.41})
    forBothTurns([height](AirScene& scene) {
      addRoomWithCupboards(scene, height);
      const Parted air(scene);
      EXPECT_EQ(air.rooms(), 1u) << height;
      EXPECT_EQ(air.roomAt(1.5, 1, 3), air.roomAt(4.5, 3)) << height;
    });
}

} // namespace

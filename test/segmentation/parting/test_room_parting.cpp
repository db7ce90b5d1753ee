// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/parting/room_borders.h"
#include "sedr_segmentation/src/parting/room_parting.h"
#include "sedr_segmentation/src/parting/walked_floors.h"

#include "segmentation/air/air_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <map>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** A scene with its air split into rooms. */
struct Parted : SceneAir {
  explicit Parted(const AirScene& of, unsigned threads = 1)
      : SceneAir(of, threads)
      , parted(partRooms(gaps, PartingParameters()))
  {}

  /** Returns the room at a place, -1 for none. */
  int roomAt(double x, double y, double z = 1) const
  {
    const std::uint32_t g = at(x, y, z);
    return g == AirGaps::none ? PartedAir::no_room : parted.room[g];
  }

  /** Returns the number of rooms larger than a square metre. */
  std::size_t rooms() const
  {
    std::map<std::int32_t, int> size;
    for (const std::int32_t r : parted.room)
      ++size[r];
    std::size_t n = 0;
    for (const auto& [room, columns_of_it] : size)
      n += room != PartedAir::no_room && columns_of_it > 100 ? 1 : 0;
    return n;
  }

  PartedAir parted;
};

/** Runs a test on a scene with and without a turn of 30 degrees. */
void
forBothTurns(const std::function<void(AirScene&)>& test)
{
  for (const double degrees : {0.0, 30.0}) {
    SCOPED_TRACE(degrees);
    AirScene scene(degrees);
    test(scene);
  }
}

/** Adds rooms of 4 m x 3 m and 3 m x 3 m, 10 cm of wall and a hole between them. */
void
addTwoRooms(AirScene& scene, Hole hole)
{
  for (const auto& [x0, x1] : {std::pair(0.05, 4.05), std::pair(4.15, 7.15)}) {
    scene.slab(x0, 0.05, x1, 3.05, 0.01);
    scene.slab(x0, 0.05, x1, 3.05, 2.51);
    for (const double y : {0.05, 3.05})
      scene.wall(x0, y, x1, y, 0.01, 2.51);
  }
  for (const double x : {0.05, 7.15})
    scene.wall(x, 0.05, x, 3.05, 0.01, 2.51);
  scene.partition(4.05, 0.05, 3.05, 0.01, 2.51, hole);
}

TEST(PartRooms, ADoorWithALintelPartsTwoRooms)
{
  forBothTurns([](AirScene& scene) {
    addTwoRooms(scene, {1.05, 1.95, 2.11});
    const Parted air(scene);
    EXPECT_EQ(air.rooms(), 2u);
    EXPECT_EQ(air.roomAt(2, 1.5), 0) << "the larger one is the first";
    EXPECT_EQ(air.roomAt(5.5, 1.5), 1);
    ASSERT_EQ(air.parted.openings.size(), 1u);
    const RoomOpening& door = air.parted.openings.front();
    EXPECT_EQ(door.a, 0u);
    EXPECT_EQ(door.b, 1u);
    EXPECT_NEAR((door.middle - scene.place(4.1, 1.5)).norm(), 0, 0.25);
    EXPECT_NEAR(door.width, 0.9, 0.25);
    EXPECT_NEAR(door.bottom, 0.03, 0.06);
    EXPECT_NEAR(door.top, 2.1, 0.15);
    EXPECT_GT(std::abs(door.direction.dot(scene.place(0, 1))), 0.9) << "along the wall";
  });
}

/** Adds the same rooms, 4 m deep, with two equal openings beside a pier of 40 cm. */
void
addRoomsWithPier(AirScene& scene, double width, double head)
{
  for (const auto& [x0, x1] : {std::pair(0.05, 4.05), std::pair(4.15, 8.15)}) {
    scene.slab(x0, 0.05, x1, 6.05, 0.01);
    scene.slab(x0, 0.05, x1, 6.05, 2.91);
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
    addRoomsWithPier(scene, 2.4, 2.51);
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

TEST(PartRooms, ADoorAsHighAsTheCeilingPartsThemByItsJambs)
{
  forBothTurns([](AirScene& scene) {
    addTwoRooms(scene, {1.05, 1.95, 2.51});
    const Parted air(scene);
    EXPECT_EQ(air.rooms(), 2u);
    EXPECT_NE(air.roomAt(2, 1.5), air.roomAt(5.5, 1.5));
  });
}

TEST(PartRooms, AsHighADoorPartsASmallRoomFromAHallWhoseOutlineItKeeps)
{
  forBothTurns([](AirScene& scene) {
    scene.slab(0.05, 0.05, 6.05, 6.05, 0.01);
    scene.slab(0.05, 0.05, 6.05, 6.05, 2.51);
    scene.slab(6.15, 0.05, 9.15, 3.05, 0.01);
    scene.slab(6.15, 0.05, 9.15, 3.05, 2.51);
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

TEST(PartRooms, AWallWithoutADoorPartsThemWithoutAnOpening)
{
  forBothTurns([](AirScene& scene) {
    scene.room(0.05, 0.05, 4.05, 3.05, 0.01, 2.51);
    scene.room(4.15, 0.05, 7.15, 3.05, 0.01, 2.51);
    const Parted air(scene);
    EXPECT_EQ(air.rooms(), 2u);
    EXPECT_TRUE(air.parted.openings.empty());
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
  scene.slab(0.05, 0.05, 8.05, 6.05, 0.01);
  scene.slab(0.05, 0.05, 8.05, 6.05, 2.81);
  scene.slab(8.05, low, 14.05, high, 0.01);
  scene.slab(8.05, low, 14.05, high, 2.81);
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
  for (const double width : {1.4, 2.0, 3.0})
    forBothTurns([&](AirScene& scene) {
      addHallWithCorridor(scene, width, 0.3);
      const Parted air(scene);
      EXPECT_EQ(air.rooms(), 2u) << width;
      EXPECT_NE(air.roomAt(4, 3), air.roomAt(12, 3)) << width;
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

TEST(PartRooms, TheAirOnAGalleryIsNotThatBelowIt)
{
  forBothTurns([](AirScene& scene) {
    scene.room(0.05, 0.05, 12.05, 6.05, 0.01, 5.51);
    scene.slab(8.05, 0.05, 12.05, 6.05, 2.51);
    scene.slab(8.05, 0.05, 12.05, 6.05, 2.81);
    scene.wall(8.05, 0.05, 8.05, 6.05, 2.51, 2.81);
    const Parted air(scene);
    EXPECT_NE(air.roomAt(10, 3, 4), air.roomAt(10, 3, 1));
    EXPECT_NE(air.roomAt(10, 3, 4), air.roomAt(4, 3, 1)) << "nor that of the hall";
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

TEST(PartRooms, TwoStoreysAreTwo)
{
  forBothTurns([](AirScene& scene) {
    scene.room(0.05, 0.05, 4.05, 3.05, 0.01, 2.51);
    scene.room(0.05, 0.05, 4.05, 3.05, 2.81, 5.31);
    const Parted air(scene);
    EXPECT_EQ(air.rooms(), 2u);
    EXPECT_NE(air.roomAt(2, 1.5, 1), air.roomAt(2, 1.5, 4));
    EXPECT_TRUE(air.parted.openings.empty());
  });
}

TEST(PartRooms, FromLargestToSmallestEachOfItsOwnNumber)
{
  AirScene scene;
  scene.room(0.05, 0.05, 2.05, 2.05, 0.01, 2.51);
  scene.room(3.05, 0.05, 8.05, 4.05, 0.01, 2.51);
  scene.room(9.05, 0.05, 12.05, 3.05, 0.01, 2.51);
  const Parted air(scene);
  EXPECT_EQ(air.parted.rooms, 3u);
  EXPECT_EQ(air.roomAt(5, 2), 0);
  EXPECT_EQ(air.roomAt(10, 2), 1);
  EXPECT_EQ(air.roomAt(1, 1), 2);
  EXPECT_EQ(air.roomAt(2.55, 1), -1);
}

TEST(PartRooms, TheSameForAnyNumberOfThreads)
{
  AirScene scene(30);
  addTwoRooms(scene, {1.05, 1.95, 2.11});
  scene.room(8, 8, 24, 20, 0.01, 3.01);
  EXPECT_EQ(Parted(scene, 1).parted.room, Parted(scene, 3).parted.room);
}

TEST(PartRooms, OfNoAirThereAreNone)
{
  const AirScene scene;
  const Parted air(scene);
  EXPECT_EQ(air.parted.rooms, 0u);
  EXPECT_TRUE(air.parted.room.empty());
}

/** A corridor of 8 m x 1 m beside a room of 3 m x 3 m, with an opening up to the
 * ceiling at the end of the room's wall. */
void
addCorridor(AirScene& scene, double opening)
{
  scene.slab(0.05, 0.05, 1.05, 8.05, 0.01);
  scene.slab(0.05, 0.05, 1.05, 8.05, 2.51);
  scene.slab(1.15, 5.05, 4.15, 8.05, 0.01);
  scene.slab(1.15, 5.05, 4.15, 8.05, 2.51);
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

TEST(PartRooms, AVoidOverTwoStoreysIsOfTheLower)
{
  forBothTurns([](AirScene& scene) { // 6 m x 6 m, with a hole of 2 m x 2 m in the slab
    scene.slab(0.05, 0.05, 6.05, 6.05, 0.01);
    scene.slab(0.05, 0.05, 6.05, 6.05, 6.01);
    scene.sides(0.05, 0.05, 6.05, 6.05, 0.01, 6.01);
    for (const double z : {2.71, 3.01})
      for (const auto& [x0, y0, x1, y1] :
           {std::array{0.05, 0.05, 6.05, 2.05}, std::array{0.05, 4.05, 6.05, 6.05},
            std::array{0.05, 2.05, 2.05, 4.05}, std::array{4.05, 2.05, 6.05, 4.05}})
        scene.slab(x0, y0, x1, y1, z);
    scene.sides(2.05, 2.05, 4.05, 4.05, 2.71, 3.01);
    const Parted air(scene);
    EXPECT_EQ(air.rooms(), 2u);
    EXPECT_EQ(air.roomAt(3, 3, 1), air.roomAt(1, 1, 1));
    EXPECT_NE(air.roomAt(3, 3, 1), air.roomAt(1, 1, 4));
  });
}

/** The jambs of a doorway of 0.9 m through a wall of 50 cm between two rooms, which
 * meet at x within it. */
std::array<double, 2>
jambsOfRoomsThatMeetAt(AirScene& scene, double x)
{
  for (const double z : {0.01, 2.51}) {
    scene.slab(0.05, 0.05, 3.05, 3.05, z);
    scene.slab(3.05, 1.05, 3.55, 1.95, z);
    scene.slab(3.55, 0.05, 6.55, 3.05, z);
  }
  for (const auto& [x0, x1] : {std::pair(0.05, 3.05), std::pair(3.55, 6.55)}) {
    scene.wall(x0, 0.05, x1, 0.05, 0.01, 2.51);
    scene.wall(x0, 3.05, x1, 3.05, 0.01, 2.51);
  }
  for (const double side : {0.05, 6.55})
    scene.wall(side, 0.05, side, 3.05, 0.01, 2.51);
  for (const double face : {3.05, 3.55}) {
    scene.wall(face, 0.05, face, 1.05, 0.01, 2.51);
    scene.wall(face, 1.95, face, 3.05, 0.01, 2.51);
  }
  for (const double side : {1.05, 1.95})
    scene.wall(3.05, side, 3.55, side, 0.01, 2.51);
  const SceneAir air(scene);
  std::vector<std::int32_t> label(air.gaps.size());
  for (std::uint32_t g = 0; g < air.gaps.size(); ++g)
    label[g] = (air.columns.grid().centre(air.columns.cellOf(air.gaps[g].column)) -
                scene.place(x, 0))
                           .dot(scene.place(1, 0)) < 0
                   ? 0
                   : 1;
  RoomLabels labels(std::move(label));
  const auto crossings = crossingsOf(air.gaps, labels, false);
  const std::vector<float> no_dip(air.gaps.size(), 0.0F);
  const PartingParameters parameters;
  const MeasuredOpening opening = OpeningMeasures(air.gaps, no_dip, parameters)
                                      .measure(crossings.begin()->second, labels);
  return {opening.jamb_a, opening.jamb_b};
}

TEST(OpeningMeasures, FindTheJambsWhereverInAWallTwoRoomsMeet)
{
  for (const double x : {3.1, 3.3, 3.5})
    forBothTurns([x](AirScene& scene) {
      const std::array<double, 2> jambs = jambsOfRoomsThatMeetAt(scene, x);
      EXPECT_NEAR(jambs[0], 1, 0.3) << "the wall beside the door is 1 m, " << x;
      EXPECT_NEAR(jambs[1], 1, 0.3) << x;
    });
}

/** A room of 6 m x 5 m, 4.3 m high, with cupboards of 3 m x 2 m in a corner. */
void
addRoomWithCupboards(AirScene& scene, double height)
{
  scene.slab(3.05, 0.05, 6.05, 5.05, 0.01); // the cupboards hide the floor
  scene.slab(0.05, 2.05, 3.05, 5.05, 0.01);
  scene.slab(0.05, 0.05, 6.05, 5.05, 4.31);
  scene.sides(0.05, 0.05, 6.05, 5.05, 0.01, 4.31);
  scene.slab(0.05, 0.05, 3.05, 2.05, height);
  scene.wall(3.05, 0.05, 3.05, 2.05, 0.01, height);
  scene.wall(0.05, 2.05, 3.05, 2.05, 0.01, height);
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

/** The columns of wall between two rooms, which a place is of or not. */
std::size_t
wallsBetween(const SceneAir& air,
             const std::function<bool(const Eigen::Vector3d&)>& is_of_first)
{
  std::vector<std::int32_t> label(air.gaps.size());
  for (std::uint32_t g = 0; g < air.gaps.size(); ++g) {
    const Eigen::Vector2d at =
        air.columns.grid().centre(air.columns.cellOf(air.gaps[g].column));
    const double z = air.columns.heightOf(air.gaps[g].low);
    label[g] = is_of_first({at.x(), at.y(), z}) ? 0 : 1;
  }
  RoomLabels labels(std::move(label));
  const RoomBorders borders(air.gaps, 0.6, labels);
  return borders.between({0, 1}).walls;
}

TEST(RoomBorders, HaveWallsWhereWallsStand)
{
  AirScene scene;
  addTwoRooms(scene, {1.05, 1.95, 2.11});
  const SceneAir air(scene);
  EXPECT_NEAR(wallsBetween(air, [](const auto& p) { return p.x() < 4.1; }), 21, 2)
      << "3 m but for a door of 0.9 m";
}

TEST(RoomBorders, HaveNoneAtTheEdgeOfAGallery)
{
  AirScene scene;
  scene.room(0.05, 0.05, 6.05, 3.05, 0.01, 4.31);
  scene.slab(3.05, 0.05, 6.05, 3.05, 2.11);
  const SceneAir air(scene);
  EXPECT_EQ(wallsBetween(air, [](const auto& p) { return p.z() < 1; }), 0u);
}

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

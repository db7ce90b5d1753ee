// SPDX-License-Identifier: BSD-3-Clause
// What parts rooms, and what does not: scenes and the number of their rooms.
#include "segmentation/rooms/building_scene.h"
#include "segmentation/rooms/stairs_scene.h"

#include <gtest/gtest.h>

#include <ostream>
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

/** Adds two rooms, 4 m x 6 m, with two equal openings beside a pier of 40 cm. */
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

/** Adds a corridor of 8 m x 1 m beside a room of 3 m x 3 m, with an opening up to the
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

/** Adds a room of 6 m x 5 m, 4.3 m high, with cupboards of 3 m x 2 m in a corner. */
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

struct PartedScene {
  const char* name;
  std::size_t rooms;
  std::function<void(AirScene&)> add;
};

std::ostream&
operator<<(std::ostream& stream, const PartedScene& scene)
{
  return stream << scene.name;
}

const std::vector<PartedScene>&
partedScenes()
{
  using Scene = AirScene&;
  const auto hall = [](double width, double lintel) {
    return [=](Scene scene) { addHallWithCorridor(scene, width, lintel); };
  };
  const auto beam = [](double depth) {
    return [=](Scene scene) {
      scene.room(0.05, 0.05, 8.05, 4.05, 0.01, 2.81);
      scene.hanging(3.85, 0.05, 4.15, 4.05, 2.81 - depth, 2.81);
    };
  };
  static const std::vector<PartedScene> scenes{
      {"a_door_through_a_thick_wall", 2, addRoomsBehindAThickWall},
      {"two_doors_side_by_side", 2,
       [](Scene scene) { addRoomsWithPier(scene, 0.9, 2.11); }},
      {"a_column_in_a_wide_opening_below_a_beam", 1,
       [](Scene scene) { addRoomsWithPier(scene, 2.7, 2.51); }},
      {"a_wall_of_which_little_is_left", 1,
       [](Scene scene) {
         addTwoRooms(scene, {0.35, 2.75, 2.51});
       }},
      {"a_low_beam", 1, beam(0.2)},
      {"a_beam", 1, beam(0.4)},
      {"a_deep_beam", 1, beam(0.6)},
      {"a_beam_on_columns", 1,
       [](Scene scene) {
         scene.room(0.05, 0.05, 24.05, 6.05, 0.01, 2.81);
         scene.hanging(11.85, 0.05, 12.25, 6.05, 2.21, 2.81);
         for (const double y : {1.45, 4.25})
           scene.sides(11.85, y, 12.25, y + 0.4, 0.01, 2.21);
       }},
      {"a_pier_between_two_ways", 2,
       [](Scene scene) {
         scene.room(0.05, 0.05, 2.95, 8.15, 0.01, 2.61);
         for (const auto& [from, to] :
              {std::pair(0.05, 0.25), {1.15, 1.75}, {2.75, 2.95}})
           scene.sides(from, 4.05, to, 4.15, 0.01, 2.61);
       }},
      {"ribs", 1,
       [](Scene scene) {
         scene.room(0.05, 0.05, 8.05, 4.05, 0.01, 2.81);
         for (double x = 0.85; x < 8; x += 1)
           scene.hanging(x, 0.05, x + 0.2, 4.05, 2.51, 2.81);
       }},
      {"lamps_that_hang_in_a_row", 1,
       [](Scene scene) {
         scene.room(0.05, 0.05, 8.05, 4.05, 0.01, 2.81);
         for (double y = 0.35; y < 3.5; y += 0.9)
           scene.slab(4, y, 4.2, y + 0.6, 2.21);
         scene.slab(6, 2, 6.1, 2.1, 1.51); // one on a long cord
       }},
      {"a_narrow_corridor_that_is_open_to_a_hall", 1, hall(1.4, 0)},
      {"a_corridor_that_is_open_to_a_hall", 1, hall(2, 0)},
      {"a_wide_corridor_that_is_open_to_a_hall", 1, hall(3, 0)},
      {"a_narrow_corridor_below_a_lintel", 2, hall(1.4, 0.4)},
      {"a_corridor_below_a_lintel", 2, hall(2, 0.5)},
      {"a_wide_corridor_below_a_lintel", 2, hall(3, 0.7)},
      {"a_corridor_below_10_cm", 1, hall(2, 0.11)},
      {"columns", 1,
       [](Scene scene) {
         scene.room(0.05, 0.05, 12.05, 9.05, 0.01, 2.81);
         for (double x = 2.85; x < 11; x += 3)
           for (double y = 2.85; y < 8; y += 3)
             scene.sides(x, y, x + 0.4, y + 0.4, 0.01, 2.81);
       }},
      {"a_step_in_floor_and_ceiling", 1,
       [](Scene scene) {
         scene.slab(0.05, 0.05, 4.05, 4.05, 0.01);
         scene.slab(4.05, 0.05, 8.05, 4.05, 0.51);
         scene.wall(4.05, 0.05, 4.05, 4.05, 0.01, 0.51);
         scene.slab(0.05, 0.05, 3.05, 4.05, 2.51);
         scene.slab(3.05, 0.05, 8.05, 4.05, 3.21);
         scene.wall(3.05, 0.05, 3.05, 4.05, 2.51, 3.21);
         scene.sides(0.05, 0.05, 8.05, 4.05, 0.01, 3.21);
       }},
      {"an_opening_wider_than_a_leaf_without_a_lintel", 1,
       [](Scene scene) { addCorridor(scene, 2); }}};
  return scenes;
}

class PartRooms : public testing::TestWithParam<PartedScene> {};

TEST_P(PartRooms, IntoAsManyAsThereAre)
{
  for (const double degrees : {0.0, 30.0}) {
    AirScene scene(degrees);
    GetParam().add(scene);
    EXPECT_EQ(Found(scene).building.rooms.size(), GetParam().rooms) << degrees;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes,
                         PartRooms,
                         testing::ValuesIn(partedScenes()),
                         [](const auto& scene) { return scene.param.name; });

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

TEST(PartedRooms, AsHighADoorPartsASmallRoomFromAHallWhoseOutlineItKeeps)
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
    const Found found(scene);
    EXPECT_EQ(found.building.rooms.size(), 2u);
    for (const auto& [x, y] : {std::pair(7.0, 0.4), std::pair(8.8, 0.4),
                               std::pair(8.8, 2.7), std::pair(7.0, 2.7)})
      EXPECT_EQ(found.roomAt(x, y), 2u) << x << ' ' << y;
  });
}

TEST(PartedRooms, TheAirOnAGalleryIsNotThatBelowIt)
{
  forBothTurns([](AirScene& scene) {
    scene.room(0.05, 0.05, 12.05, 6.05, 0.01, 5.51);
    scene.slabs(8.05, 0.05, 12.05, 6.05, 2.51, 2.81);
    scene.wall(8.05, 0.05, 8.05, 6.05, 2.51, 2.81);
    const Found found(scene);
    EXPECT_NE(found.roomAt(10, 3, 4), found.roomAt(10, 3, 1));
    EXPECT_NE(found.roomAt(10, 3, 4), found.roomAt(4, 3, 1)) << "nor that of the hall";
  });
}

TEST(PartedRooms, ASmallClosetIsNotOfTheRoomAboveItIntoWhichAShaftLeads)
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
    BuildingParameters parameters;
    parameters.minimum_area = 0.3;
    const Found found(scene, parameters);
    const std::uint32_t upper = found.roomAt(4, 3, 4);
    EXPECT_EQ(found.roomAt(0.5, 0.5, 4), upper) << "above the closet";
    EXPECT_NE(found.roomAt(0.5, 0.5, 1), upper);
    ASSERT_EQ(found.building.left_out.size(), 2u);
    EXPECT_NEAR(found.building.left_out[0].ceiling, 2.01, 0.06) << "nor lost";
  });
}

TEST(PartedRooms, AStairwellPartsNothingOfTheStoreyAboveAndIsNoneOfTheOneBelow)
{
  forBothTurns([](AirScene& scene) {
    addStoreysWithStairs(scene);
    const Found found(scene);
    EXPECT_EQ(found.building.rooms.size(), 2u);
    const std::uint32_t upper = found.roomAt(2, 1, 4);
    EXPECT_NE(found.roomAt(2, 1, 1), upper);
    EXPECT_EQ(found.roomAt(2, 6.5, 4), upper) << "behind the shaft";
    EXPECT_EQ(found.roomAt(1.45, 3.5, 4), upper) << "beside it";
    EXPECT_EQ(found.roomAt(0.55, 3.5, 4), upper) << "over the stairs";
  });
}

TEST(PartedRooms, ALoftOpenOnTwoSidesTakesNoFloorFromTheHallBelow)
{
  forBothTurns([](AirScene& scene) {
    scene.room(0.05, 0.05, 6.05, 5.05, 0.01, 5.01);
    scene.slabs(0.05, 0.05, 2.05, 2.05, 2.21, 2.41);
    const Found found(scene);
    EXPECT_EQ(found.roomAt(1, 1, 1), found.roomAt(4, 3, 1)) << "below the loft";
  });
}

TEST(PartedRooms, ANookBelowABeamWithADoorToTheNextRoomIsOfTheHallItOpensTo)
{
  forBothTurns([](AirScene& scene) {
    addTwoRooms(scene, {1.05, 1.95, 2.11}); // the door from the second room
    // Before the door 1 m of the hall is 2.4 m wide, below a beam at its mouth.
    for (const auto& [from, to] : {std::pair(0.05, 0.35), std::pair(2.75, 3.05)})
      scene.sides(3.05, from, 4.05, to, 0.01, 2.51);
    scene.hanging(3.05, 0.35, 3.15, 2.75, 2.21, 2.51);
    const Found found(scene);
    EXPECT_EQ(found.building.rooms.size(), 2u);
    EXPECT_EQ(found.roomAt(3.5, 1.5), found.roomAt(2, 1.5));
    EXPECT_NE(found.roomAt(3.5, 1.5), found.roomAt(5.5, 1.5));
  });
}

TEST(PartedRooms, ADoorwayAsWideAsTheCorridorPartsThem)
{
  forBothTurns([](AirScene& scene) {
    addCorridor(scene, 1.0);
    const Found found(scene);
    EXPECT_EQ(found.building.rooms.size(), 2u);
    EXPECT_EQ(found.roomAt(0.55, 1), found.roomAt(0.55, 7.5)) << "the corridor is one";
    EXPECT_NE(found.roomAt(0.55, 5.85), found.roomAt(2.5, 6.5));
  });
}

TEST(PartedRooms, TheAirOnFurnitureIsOfTheRoomHoweverHighItIs)
{
  for (const double height : {1.51, 2.01, 2.41})
    forBothTurns([height](AirScene& scene) {
      addRoomWithCupboards(scene, height);
      const Found found(scene);
      EXPECT_EQ(found.building.rooms.size(), 1u) << height;
      EXPECT_EQ(found.roomAt(1.5, 1, 3), found.roomAt(4.5, 3)) << height;
    });
}

} // namespace

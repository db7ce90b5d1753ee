// SPDX-License-Identifier: BSD-3-Clause
#include "simulator/sample_rooms.h"
#include "simulator/scene/scenes.h"
#include "simulator/truth/room_truth.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

namespace pcl::sedr::sim::test {
namespace {

RoomTruth
truthOf(Room room)
{
  return roomTruths(makeScene(std::move(room), {}, 1)).at(0);
}

TEST(RoomTruth, ofARectangleWithAColumn)
{
  Room room = makeBoxRoom(5.0, 4.0, 3.0);
  room.columns.push_back(rectangleLoop({1.0, 1.0}, {1.5, 2.0}));
  const RoomTruth truth = truthOf(room);
  EXPECT_EQ(truth.name, "box");
  EXPECT_EQ(truth.id, 1U);
  EXPECT_NEAR(truth.area, 19.5, 1e-12);
  EXPECT_NEAR(truth.perimeter, 18.0, 1e-12);
  EXPECT_NEAR(truth.column_perimeter, 3.0, 1e-12);
  EXPECT_NEAR(truth.height, 3.0, 1e-12);
  EXPECT_NEAR(truth.volume, 58.5, 1e-9);
}

TEST(RoomTruth, ofARoomWithAnArcIsThatOfItsChordsWithinAMillimetre)
{
  Room room = makeBoxRoom(4.0, 2.0, 2.5);
  room.outline[1].bulge = 1.0; // the side of 2 m swells out by half a circle
  const RoomTruth truth = truthOf(room);
  EXPECT_NEAR(truth.area, 8.0 + 0.5 * pi, 1e-9);
  EXPECT_NEAR(truth.perimeter, 10.0 + pi, 1e-9);
  EXPECT_NEAR(truth.height, 2.5, 1e-9);
  EXPECT_NEAR(truth.volume, 2.5 * (8.0 + 0.5 * pi), 2.5 * pi * kChordTolerance);
}

TEST(RoomTruth, heightIsTheMeanUnderDetails)
{
  Room room = makeBoxRoom(5.0, 4.0, 3.0);
  room.floor.height = 0.5; // the room is 2.5 m high
  room.details.push_back({rectangleLoop({1.0, 1.0}, {3.0, 3.0}), {2.5}});
  room.details.push_back({rectangleLoop({3.5, 1.0}, {4.5, 2.0}), {3.2}});
  const RoomTruth truth = truthOf(room);
  EXPECT_NEAR(truth.volume, 20.0 * 2.5 - 4.0 * 0.5 + 0.2, 1e-9);
  EXPECT_NEAR(truth.height, truth.volume / 20.0, 1e-9);
}

TEST(RoomTruth, isInTheFrameOfTheFiles)
{
  Scene scene = makeScene(makeBoxRoom(5.0, 4.0, 3.0), {}, 1);
  scene.placement = {90.0, {10.0, 20.0, -1.0}};
  const RoomTruth truth = roomTruths(scene).at(0);
  ASSERT_EQ(truth.outline.size(), 4U);
  EXPECT_NEAR(truth.outline[1].position.x, 10.0, 1e-12);
  EXPECT_NEAR(truth.outline[1].position.y, 25.0, 1e-12);
  EXPECT_NEAR(areaOf(truth.outline), 20.0, 1e-9); // still counter-clockwise
  EXPECT_NEAR(truth.volume, 60.0, 1e-9);
}

TEST(RoomTruth, isThereForEveryRoom)
{
  const Scene scene = sceneNamed("syn_flat");
  const auto truths = roomTruths(scene);
  ASSERT_EQ(truths.size(), 4U);
  EXPECT_NEAR(truths[0].area, 5.7 * 3.7, 1e-9);
  for (std::size_t i = 0; i < truths.size(); ++i) {
    EXPECT_EQ(truths[i].id, i + 1);
    EXPECT_EQ(truths[i].name, scene.rooms[i].name);
    EXPECT_NEAR(truths[i].volume, truths[i].area * truths[i].height, 1e-9);
  }
}

TEST(RoomTruth, isWrittenAsJson)
{
  Room room = makeBoxRoom(4.0, 2.0, 2.5);
  room.outline[1].bulge = 1.0;
  room.columns.push_back(circleLoop({1.0, 1.0}, 0.25));
  const auto json = nlohmann::json::parse(roomTruthsToJson("sample", {truthOf(room)}));
  EXPECT_EQ(json["format"], "sedr-room-truth");
  EXPECT_EQ(json["scene"], "sample");
  const auto& written = json["rooms"].at(0);
  EXPECT_NEAR(written["area"].get<double>(), truthOf(room).area, 1e-12);
  EXPECT_EQ(written["boundary"].size(), 4U);
  EXPECT_EQ(written["boundary"][0]["type"], "segment");
  const auto& arc = written["boundary"][1];
  EXPECT_EQ(arc["type"], "arc");
  EXPECT_NEAR(arc["centre"][0].get<double>(), 4.0, 1e-12);
  EXPECT_NEAR(arc["centre"][1].get<double>(), 1.0, 1e-12);
  EXPECT_NEAR(arc["radius"].get<double>(), 1.0, 1e-12);
  EXPECT_EQ(arc["counter_clockwise"], true);
  EXPECT_EQ(written["columns"].at(0).size(), 2U);
}

} // namespace
} // namespace pcl::sedr::sim::test

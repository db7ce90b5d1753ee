// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include <pcl/sedr_segmentation/settled_rooms.h>

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** A room of 4 m x 3 m whose wall to a hall of 2 m x 2 m stands behind a wardrobe, of
 * the hall what a scanner sees that never stood in it: nothing of that wall, unless
 * `is_seen`. Of both nobody saw where they end, so that the hall, the smaller one, was
 * closed 0.3 m into the room. */
struct RoomAndHall {
  explicit RoomAndHall(bool is_seen)
  {
    plan.rooms = {roomOf(rectangle(0, 0, 4, 3), 2.5),
                  roomOf(rectangle(3.7, 0.5, 6, 2.5), 2.5)};
    plan.rooms[0].id = 1;
    plan.rooms[1].id = 2;
    points.room(plan.rooms[0], [](const Eigen::Vector3d& p) { return p.x() < 3.35; });
    points.wall(segment({3.4, 0}, {3.4, 3}), 0, 2.4);
    points.room(plan.rooms[1], [is_seen](const Eigen::Vector3d& p) {
      return p.x() > 4.15 || (is_seen && p.x() < 3.71);
    });
  }

  std::vector<std::string> settle()
  {
    return settleRooms(plan, points.view(), points.all(), 1);
  }

  Floorplan plan;
  RoomPoints points;
};

TEST(SettledRooms, ARoomThatIsLeftOutHasTakenNothingFromOthers)
{
  RoomAndHall scene(false);
  const std::vector<std::string> sentences = scene.settle();
  ASSERT_EQ(scene.plan.rooms.size(), 1u);
  EXPECT_EQ(scene.plan.rooms[0].id, 1u);
  EXPECT_NEAR(scene.plan.rooms[0].area(), 12, 1e-9);
  for (const PlanElement& e : scene.plan.rooms[0].boundary.elements)
    EXPECT_TRUE(e.evidence.isKnown());
  ASSERT_EQ(sentences.size(), 1u) << "of the room that is gone, not of its cut";
  EXPECT_EQ(sentences[0].find("room 2:"), 0u) << sentences[0];
}

TEST(SettledRooms, EndsThoughRoomsShareAnId)
{
  RoomAndHall scene(false);
  scene.plan.rooms[1].id = scene.plan.rooms[0].id;
  const std::vector<std::string> sentences = scene.settle();
  EXPECT_EQ(scene.plan.rooms.size(), 1u);
  EXPECT_FALSE(sentences.empty());
}

TEST(SettledRooms, RoomsThatStayAreParted)
{
  RoomAndHall scene(true);
  const std::vector<std::string> sentences = scene.settle();
  ASSERT_EQ(scene.plan.rooms.size(), 2u);
  EXPECT_NEAR(scene.plan.rooms[0].area(), 12 - 0.31 * 2.02, 1e-6);
  EXPECT_NEAR(scene.plan.rooms[1].area(), 2.3 * 2, 1e-9);
  EXPECT_EQ(sentences.size(), 1u);
}

} // namespace

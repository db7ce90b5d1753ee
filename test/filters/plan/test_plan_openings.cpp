// SPDX-License-Identifier: BSD-3-Clause
#include "two_storeys.h"

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_filters/plan_opening.h>

#include <gtest/gtest.h>

#include <string>

namespace pcl::sedr {
namespace {

Floorplan
planWithADoor()
{
  Floorplan plan{{sedr_test::roomOf(sedr_test::rectangle(0, 0, 4, 3), 2.5, 3)}};
  plan.openings = {sedr_test::ajarDoor()};
  return plan;
}

TEST(PlanOpenings, AreNumberedInTheirKindFromTheLowestStoreyUpAndKeepTheirNumbers)
{
  Floorplan plan = sedr_test::twoStoreys();
  const auto opening = [](OpeningKind kind, std::uint32_t room) {
    PlanOpening o;
    o.kind = kind;
    o.rooms = {room, 0};
    o.end = {1, 0};
    o.top = 2;
    return o;
  };
  plan.openings = {opening(OpeningKind::Window, 4),  opening(OpeningKind::Door, 3),
                   opening(OpeningKind::Window, 1),  opening(OpeningKind::Window, 2),
                   opening(OpeningKind::Passage, 2), opening(OpeningKind::Unknown, 1)};
  const auto marks = [&plan] {
    std::string all;
    for (const PlanOpening& o : plan.openings)
      all += markOf(o) + " ";
    return all;
  };
  numberOpenings(plan);
  EXPECT_EQ(marks(), "W3 D1 W1 W2 P1 O1 ");
  std::string problem;
  EXPECT_EQ(floorplanToJson(floorplanFromJson(floorplanToJson(plan), problem)),
            floorplanToJson(plan));
  plan.openings.erase(plan.openings.begin() + 2);
  plan.openings.push_back(opening(OpeningKind::Window, 1));
  numberOpenings(plan);
  EXPECT_EQ(marks(), "W3 D1 W2 P1 O1 W4 ");
}

TEST(PlanOpenings, LeavesHangAtTheFaceOfTheirSide)
{
  PlanOpening door = planWithADoor().openings[0];
  ASSERT_EQ(leavesOf(door).size(), 1u);
  EXPECT_TRUE(leavesOf(door)[0].hinge.isApprox(Eigen::Vector2d(1.9, 0)));
  EXPECT_TRUE(leavesOf(door)[0].shut.isApprox(Eigen::Vector2d(1, 0)));
  EXPECT_TRUE(leavesOf(door)[0].open.isApprox(Eigen::Vector2d(1.9, 0.9)));
  door.hinge = OpeningHinge::Both;
  door.swing = 0; // the outside, to the right
  ASSERT_EQ(leavesOf(door).size(), 2u);
  EXPECT_TRUE(leavesOf(door)[0].hinge.isApprox(Eigen::Vector2d(1, -0.2)));
  EXPECT_TRUE(leavesOf(door)[0].shut.isApprox(Eigen::Vector2d(1.45, -0.2)));
  EXPECT_TRUE(leavesOf(door)[1].open.isApprox(Eigen::Vector2d(1.9, -0.65)));
  door.hinge = OpeningHinge::Unknown;
  EXPECT_TRUE(leavesOf(door).empty());
}

TEST(PlanOpenings, AreWhereTheirWidthAndHeightsAre)
{
  const PlanOpening door = planWithADoor().openings[0];
  EXPECT_TRUE(isAt(door, {1.5, 0}, 0, 2));
  EXPECT_TRUE(isAt(door, {1.5, -0.5}, 0, 2)) << "at the other side of the wall";
  EXPECT_FALSE(isAt(door, {2, 0}, 0, 2)) << "beside it";
  EXPECT_FALSE(isAt(door, {1.5, 0.5}, 0, 2)) << "in the room";
  EXPECT_FALSE(isAt(door, {1.5, 0}, 2.8, 4.8)) << "a storey above";
}

/** Two rooms with a wall of 10 cm from x = 4 to 4.1, and with openings; a file of an
 * earlier version that has these doorways, too. */
Floorplan
readEarlier(const std::string& doorways,
            const std::vector<PlanOpening>& openings = {},
            std::string* problem = nullptr)
{
  using namespace sedr_test;
  Floorplan plan;
  plan.rooms = {roomOf(rectangle(0, 0, 4, 3), 2.5),
                roomOf(rectangle(4.1, 0, 8, 3), 2.5, 2)};
  plan.openings = openings;
  std::string text = floorplanToJson(plan);
  text.replace(text.find("\"version\": 3"), 12, "\"version\": 1");
  text.insert(text.find("\"stairs\""), "\"doorways\": [" + doorways + "], ");
  std::string found;
  const Floorplan read = floorplanFromJson(text, problem ? *problem : found);
  EXPECT_EQ(found, "");
  return read;
}

std::string
doorwayText(const std::string& rooms, const std::string& start, const std::string& end)
{
  return R"({"rooms": [)" + rooms + R"(], "start": [)" + start + R"(], "end": [)" +
         end + R"(], "bottom": 0.01, "top": 2.05})";
}

TEST(PlanOpenings, DoorwaysOfEarlierVersionsAreOpeningsThroughTheirWall)
{
  for (const char* x : {"3.95", "4.05", "4.2"})
    for (const bool is_up : {false, true}) {
      const std::string a = x + std::string(", 1");
      const std::string b = x + std::string(", 2");
      const Floorplan plan =
          readEarlier(doorwayText("1, 2", is_up ? a : b, is_up ? b : a));
      ASSERT_EQ(plan.openings.size(), 1u);
      const PlanOpening& opening = plan.openings[0];
      EXPECT_EQ(opening.kind, OpeningKind::Unknown);
      EXPECT_EQ(opening.rooms, (std::array<std::uint32_t, 2>{1, 2}));
      ASSERT_EQ(opening.walls.size(), 2u);
      EXPECT_EQ(opening.walls[0].element, 1u);
      EXPECT_EQ(opening.walls[1].element, 3u);
      EXPECT_TRUE(opening.start.isApprox(Eigen::Vector2d(4.05, 1))) << x;
      EXPECT_TRUE(opening.end.isApprox(Eigen::Vector2d(4.05, 2)))
          << x << ": room 1 is to the left";
      EXPECT_NEAR(opening.depth, 0.1, 1e-9);
      EXPECT_EQ(opening.bottom, 0.01);
      EXPECT_EQ(opening.top, 2.05);
    }
  const Floorplan cut = readEarlier(doorwayText("1, 2", "4.05, -0.1", "4.05, 0.9"));
  EXPECT_NEAR(cut.openings.at(0).start.y(), 0, 1e-9) << "both rooms end there";
}

TEST(PlanOpenings, DoorwaysOfEarlierVersionsAreNoSecondOpenings)
{
  PlanOpening door = planWithADoor().openings[0];
  door.rooms = {1, 0};
  door.walls = {{1, 0}};
  door.swing = 1;
  const Floorplan plan = readEarlier(doorwayText("1, 0", "1.1, 0", "1.8, 0") + ", " +
                                         doorwayText("1, 0", "3, 0", "3.8, 0") + ", " +
                                         doorwayText("1, 0", "3, 0", "3, 0"),
                                     {door});
  ASSERT_EQ(plan.openings.size(), 2u) << "one is the door, one has no width";
  EXPECT_EQ(plan.openings[0].kind, OpeningKind::Door);
  EXPECT_EQ(plan.openings[1].start.x(), 3);
  std::string problem;
  readEarlier(doorwayText("1, 7", "3, 0", "3.8, 0"), {}, &problem);
  EXPECT_NE(problem.find("room 7"), std::string::npos) << problem;
  readEarlier(doorwayText("1", "3, 0", "3.8, 0"), {}, &problem);
  EXPECT_NE(problem.find("a doorway has 2 rooms"), std::string::npos) << problem;
}

TEST(PlanOpenings, AreReadOfVersionsUpToThisOneInMetres)
{
  std::string text = floorplanToJson(planWithADoor());
  text[text.find("\"version\": 3") + 11] = '4';
  std::string problem;
  floorplanFromJson(text, problem);
  EXPECT_NE(problem.find("versions 1 to 3 can be read"), std::string::npos) << problem;
  text = floorplanToJson(planWithADoor());
  text.replace(text.find("\"unit\": \"m\"") + 9, 1, "mm");
  floorplanFromJson(text, problem);
  EXPECT_NE(problem.find("only the metre"), std::string::npos) << problem;
}

} // namespace
} // namespace pcl::sedr

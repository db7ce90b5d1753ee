// SPDX-License-Identifier: BSD-3-Clause
#include "opening_scenes.h"

#include "sedr_filters/src/rays/sight_lines.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_segmentation/opening_detection.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace pcl::sedr {
namespace {

class OpeningsInNoise : public ::testing::TestWithParam<double> {};

INSTANTIATE_TEST_SUITE_P(Metres,
                         OpeningsInNoise,
                         ::testing::Values(0.001, 0.005, 0.01, 0.02));

TEST_P(OpeningsInNoise, NothingIsFoundInBareWalls)
{
  TwoRooms scene(GetParam());
  scene.scanMiddleWall({});
  scene.scanOuterWall({});
  EXPECT_TRUE(openingsOf(scene).empty());
}

TEST_P(OpeningsInNoise, DoorBetweenTwoRoomsIsFoundOnce)
{
  TwoRooms scene(GetParam());
  scene.scanMiddleWall({door});
  const PlanOpening found = openingOf(scene, OpeningKind::Door);
  EXPECT_GT(found.confidence, 0.5);
  EXPECT_EQ(std::max(found.rooms[0], found.rooms[1]), 2u);
  EXPECT_EQ(std::min(found.rooms[0], found.rooms[1]), 1u);
  EXPECT_EQ(found.walls.size(), 2u);
  EXPECT_NEAR(found.depth, 0.12, 0.005);
  EXPECT_EQ(found.hinge, OpeningHinge::Unknown);
  expectEdges(found, door, 4.06, 0.01);
  // The first room is to the left of the direction.
  const bool is_first = found.rooms[0] == 1;
  EXPECT_EQ(found.end.x() < found.start.x(), is_first);
}

TEST_P(OpeningsInNoise, HeadsAreArchedOrFlat)
{
  if (GetParam() > 0.01)
    GTEST_SKIP() << "noise of 2 cm blurs the reveal of an arch into the face";
  for (const double rise : {0.45, 0.2, 0.0}) {
    TwoRooms scene(GetParam());
    Cut arched = door;
    arched.top = 2.2;
    arched.rise = rise;
    scene.scanMiddleWall({arched});
    const auto found = openingsOf(scene);
    ASSERT_EQ(found.size(), 1u) << rise;
    expectEdges(found[0], arched, 4.06, 0.025);
    EXPECT_NEAR(found[0].rise, rise, 0.05);
  }
}

TEST_P(OpeningsInNoise, WindowToTheOutside)
{
  TwoRooms scene(GetParam());
  scene.scanOuterWall({window});
  scene.scanSheet(window, -0.1, 30); // glass returns few points
  const PlanOpening found = openingOf(scene, OpeningKind::Window);
  EXPECT_EQ(found.rooms[1], 0u);
  EXPECT_NEAR(found.depth, 0.2, 0.02);
  EXPECT_NEAR(std::min(found.start.x(), found.end.x()), window.from, 0.01);
  EXPECT_NEAR(std::max(found.start.x(), found.end.x()), window.to, 0.01);
  EXPECT_NEAR(found.bottom, window.bottom, 0.01);
  EXPECT_NEAR(found.top, window.top, 0.01);
}

TEST(OpeningDetection, IsLookedAtWithTheRoomBehindItsPlace)
{
  // Behind a hall: one room above another, or one beside another, whose faces are
  // farther from the hall's.
  using sedr_test::rectangle;
  using sedr_test::roomOf;
  const Cut first{1.5, 2.4, 0, 2.05};
  for (const bool is_above : {true, false})
    for (const double other_back : {TwoRooms::back, 4.24}) {
      TwoRooms scene(0.005);
      const Cut hall = is_above ? Cut{0, 5, 0, 5.4} : Cut{0, 10, 0, 2.5};
      const Cut second = is_above ? Cut{2, 3.4, 3.8, 4.9} : Cut{6.5, 7.4, 0, 2.05};
      const Cut other = is_above ? Cut{0, 5, 2.8, 5.4} : Cut{5.7, 10, 0, 2.5};
      scene.plan.rooms[0] =
          roomOf(rectangle(0, 0, hall.to, TwoRooms::face), hall.top, 1);
      scene.plan.rooms.push_back(
          roomOf(rectangle(other.from, other_back, other.to, 8.12), other.top, 3));
      scene.plan.rooms[2].floor = sedr_test::slabAt(other.bottom);
      scene.scanFace(hall, TwoRooms::face, {first, second});
      scene.scanFace({0, 5, 0, 2.5}, TwoRooms::back, {first});
      scene.scanFace(other, other_back, {second});
      scene.reveals(first, TwoRooms::face, TwoRooms::back);
      scene.reveals(second, TwoRooms::face, other_back);
      const auto found = openingsOf(scene);
      ASSERT_EQ(found.size(), 2u) << is_above << ' ' << other_back;
      for (const PlanOpening& opening : found) {
        const bool is_first =
            std::min(opening.start.x(), opening.end.x()) < 1.8 && opening.bottom < 1;
        EXPECT_EQ(std::max(opening.rooms[0], opening.rooms[1]), is_first ? 2u : 3u);
        EXPECT_EQ(std::min(opening.rooms[0], opening.rooms[1]), 1u);
        const double back = is_first ? TwoRooms::back : other_back;
        EXPECT_NEAR(opening.depth, back - TwoRooms::face, 0.01);
        expectEdges(opening, is_first ? first : second, (TwoRooms::face + back) / 2,
                    0.02);
      }
    }
}

TEST(OpeningDetection, SmallWindowOfWhichNothingWasSeen)
{
  const Cut small{2, 2.5, 1.5, 2};
  TwoRooms scene(0.005);
  scene.scanOuterWall({}, {small});
  const PlanOpening found = openingOf(scene, OpeningKind::Window);
  EXPECT_NEAR(found.width(), 0.5, 0.03);
  EXPECT_NEAR(found.bottom, small.bottom, 0.02);
  EXPECT_NEAR(found.top, small.top, 0.02);
}

TEST(OpeningDetection, ShelvesBeforeARecessAreNoWall)
{
  TwoRooms scene(0.005);
  scene.drawPlanToPane(1, 4, -0.4);
  const Cut recess{1, 4, 0, 2.5};
  scene.scanOuterWall({recess});
  scene.scanSheet(recess, -0.4);
  scene.scanSheet({1, 4, 0.75, 0.85}, 0);
  scene.scanSheet({1, 4, 1.35, 1.45}, 0);
  EXPECT_TRUE(openingsOf(scene).empty());
}

TEST(OpeningDetection, WindowWithItsBlindDown)
{
  TwoRooms scene(0.005);
  scene.scanOuterWall({window});
  scene.scanSheet(window, -0.12);
  openingOf(scene, OpeningKind::Window);
}

TEST(OpeningDetection, WindowInACornerOfAPlanDrawnToItsPane)
{
  TwoRooms scene(0.005);
  const Cut cut{0, 1.2, 0.9, 2.1};
  scene.drawPlanToPane(0, 1.2, -0.15);
  scene.scanOuterWall({cut});
  scene.scanSheet(cut, -0.15, 2);
  const PlanOpening found = openingOf(scene, OpeningKind::Window);
  EXPECT_NEAR(std::max(found.start.x(), found.end.x()), cut.to, 0.02);
  EXPECT_NEAR(found.bottom, cut.bottom, 0.02);
  EXPECT_NEAR(found.top, cut.top, 0.02);
  ASSERT_EQ(found.walls.size(), 1u);
  EXPECT_EQ(found.walls[0].element, 0u) << "the wall beside the bay is named";
}

TEST(OpeningDetection, WallOfGlassInAPlanDrawnToItsPane)
{
  for (const double top : {2.3, 2.5}) {
    TwoRooms scene(0.005);
    const Cut cut{0.15, 4.85, 0, top};
    scene.drawPlanToPane(cut.from, cut.to, -0.12);
    scene.scanOuterWall({cut});
    scene.scanSheet(cut, -0.12, 2);
    const PlanOpening found = openingOf(scene, OpeningKind::Window);
    expectEdges(found, cut, -0.1, 0.05);
  }
}

TEST(OpeningDetection, HatchOnTheFloorIsNoDoor)
{
  TwoRooms scene(0.005);
  scene.scanMiddleWall({{1.5, 2.4, 0, 1.2}});
  openingOf(scene, OpeningKind::Unknown);
}

TEST(OpeningDetection, LowHatchBetweenTwoRoomsIsFound)
{
  const Cut hatch{1.8, 3, 1.15, 1.75};
  TwoRooms scene(0.005);
  scene.scanMiddleWall({hatch});
  const auto found = openingsOf(scene);
  ASSERT_EQ(found.size(), 1u);
  expectEdges(found[0], hatch, 4.06, 0.01);
  TwoRooms shadow(0.005);
  shadow.scanMiddleWall({}, {hatch});
  EXPECT_TRUE(openingsOf(shadow).empty()) << "seen from one side only, without reveals";
}

TEST(OpeningDetection, WidePassage)
{
  TwoRooms scene(0.005);
  const Cut passage{1, 3.4, 0, 2.2};
  scene.scanMiddleWall({passage});
  const PlanOpening found = openingOf(scene, OpeningKind::Passage);
  expectEdges(found, passage, 4.06, 0.01);
}

TEST(OpeningDetection, ShadowOfAWardrobeIsNoOpening)
{
  TwoRooms scene(0.005);
  const Cut wardrobe{1, 2.2, 0, 2};
  scene.scanMiddleWall({}, {wardrobe});
  scene.scanSheet(wardrobe, 3.4);
  scene.scanOuterWall({});
  EXPECT_TRUE(openingsOf(scene).empty());
}

TEST(OpeningDetection, ShadowBesideAShelfIsNoWayOut)
{
  const Cut shelf{1, 2.2, 0, 2.2};
  for (const double front : {0.55, 1.1}) {
    TwoRooms scene(0.005);
    const Eigen::Vector2d from(0.9, 3.5); // the scanner, 1.2 m up
    const double scale = from.y() / (from.y() - front);
    const double right = from.x() + scale * (shelf.to - from.x());
    const double top = std::min(2.5, 1.2 + scale * (shelf.top - 1.2));
    scene.scanOuterWall({}, {{shelf.from, right, 0, top}});
    scene.scanSheet(shelf, front);
    scene.scanMiddleWall({});
    EXPECT_TRUE(openingsOf(scene).empty()) << front;
    std::vector<SightLine> few; // rays to the shelf
    for (float x = 1.1F; x < 2.2F; x += 0.3F)
      for (float z = 0.1F; z < 2.2F; z += 0.3F)
        few.push_back({Eigen::Vector3f(0.9F, 3.5F, 1.2F),
                       Eigen::Vector3f(x, static_cast<float>(front), z)});
    pcl::OpeningDetection<pcl::PointXYZ> detection;
    detection.setInputCloud(scene.cloud);
    detection.setSightLines(std::make_shared<const SightLines>(few));
    Floorplan plan = scene.plan;
    ASSERT_TRUE(detection.segment(plan));
    EXPECT_TRUE(plan.openings.empty()) << front;
  }
}

TEST(OpeningDetection, RaysTellAShadowFromAnOpening)
{
  TwoRooms scene(0.005);
  scene.scanMiddleWall({window});
  // Nothing shows but the hole in both faces.
  scene.leaveOut([](const pcl::PointXYZ& p) { return std::abs(p.y - 4.06) < 0.04; });
  const auto raysTo = [](float share) { // of the way to the wall
    const Eigen::Vector3f from(1.6F, 1, 1.4F);
    std::vector<SightLine> lines;
    for (float s = 0.8F; s < 2.7F; s += 0.01F)
      for (float z = 0.7F; z < 2.3F; z += 0.01F)
        lines.push_back({from, from + share * (Eigen::Vector3f(s, 4, z) - from)});
    return std::make_shared<const SightLines>(lines);
  };
  pcl::OpeningDetection<pcl::PointXYZ> detection;
  detection.setInputCloud(scene.cloud);
  for (const auto& [sight, count] :
       {std::pair(raysTo(0.5F), 0U), std::pair(raysTo(1.5F), 1U)}) {
    detection.setSightLines(sight);
    Floorplan plan = scene.plan;
    ASSERT_TRUE(detection.segment(plan));
    EXPECT_EQ(plan.openings.size(), count);
  }
}

TEST(OpeningDetection, ShadowBeforeASparseFaceDoesNotWidenADoor)
{
  TwoRooms scene(0.003);
  scene.scanMiddleWall({door}, {{2.4, 3, 0, 2.05}});
  scene.leaveOut([](const pcl::PointXYZ& p) {
    return p.y > 4.1 && p.x > 2.4 && p.x < 3.2 && std::lround(p.x / 0.015) % 5 != 0;
  });
  const auto found = openingsOf(scene);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].width(), door.to - door.from, 0.04);
}

TEST(OpeningDetection, WindowInATiltedWall)
{
  for (const double degrees : {-15.0, 4.0, 20.0}) {
    TwoRooms scene(0.005);
    scene.scanOuterWall({window});
    scene.tiltOuterWall(degrees * M_PI / 180);
    const auto found = openingsOf(scene);
    ASSERT_EQ(found.size(), 1u) << degrees;
    EXPECT_EQ(found[0].kind, OpeningKind::Window);
    expectEdges(found[0], window, -0.1, 0.015);
  }
}

TEST(OpeningDetection, WindowInACurvedWall)
{
  constexpr double radius = 3;
  constexpr double step = 0.015;
  const Cut cut{4, 5.2, 0.9, 2.1};
  Floorplan plan;
  plan.rooms.emplace_back();
  PlanRoom& room = plan.rooms[0];
  room.id = 1;
  PlanElement circle;
  circle.start = circle.end = Eigen::Vector2d(radius, 0);
  circle.radius = radius;
  room.boundary.elements = {circle};
  room.ceiling.plane = Eigen::Vector4d(0, 0, 1, -2.5);
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  const auto add = [&](double s, double behind, double z) {
    const double r = radius + behind;
    cloud->push_back(pcl::PointXYZ(static_cast<float>(r * std::cos(s / radius)),
                                   static_cast<float>(r * std::sin(s / radius)),
                                   static_cast<float>(z)));
  };
  for (double s = 0; s < 2 * M_PI * radius; s += step)
    for (double z = step; z < 2.5; z += step)
      if (!cut.contains(s, z))
        add(s, 0, z);
  for (double behind = 0; behind < 0.2; behind += step) {
    for (double z = cut.bottom; z < cut.top; z += step)
      for (const double s : {cut.from, cut.to})
        add(s, behind, z);
    for (double s = cut.from; s < cut.to; s += step)
      for (const double z : {cut.bottom, cut.top})
        add(s, behind, z);
  }
  pcl::OpeningDetection<pcl::PointXYZ> detection;
  detection.setInputCloud(cloud);
  ASSERT_TRUE(detection.segment(plan));
  ASSERT_EQ(plan.openings.size(), 1u);
  const PlanOpening& found = plan.openings[0];
  EXPECT_EQ(found.kind, OpeningKind::Window);
  EXPECT_NEAR(radius * std::atan2(found.start.y(), found.start.x()), cut.from, 0.02);
  EXPECT_NEAR(found.bottom, cut.bottom, 0.01);
  EXPECT_NEAR(found.top, cut.top, 0.01);
}

TEST(OpeningDetection, BadInputIsASentence)
{
  pcl::OpeningDetection<pcl::PointXYZ> detection;
  Floorplan plan;
  EXPECT_FALSE(detection.segment(plan));
  EXPECT_EQ(detection.getErrorMessage(), "no input cloud was set");
  TwoRooms scene(0.01);
  scene.scanMiddleWall({});
  detection.setInputCloud(scene.cloud);
  EXPECT_FALSE(detection.segment(plan));
  EXPECT_EQ(detection.getErrorMessage(), "the floor plan has no rooms");
  detection.setIndices(std::make_shared<pcl::Indices>());
  scene.plan.openings.emplace_back();
  EXPECT_FALSE(detection.segment(scene.plan));
  EXPECT_EQ(detection.getErrorMessage(), "there are no points");
  const auto far = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  far->push_back({1e6F, 0, 0});
  detection.setIndices(pcl::IndicesPtr());
  detection.setInputCloud(far);
  EXPECT_FALSE(detection.segment(scene.plan));
  EXPECT_EQ(detection.getErrorMessage(),
            "none of the 1 points lies at a wall of the floor plan");
  EXPECT_EQ(scene.plan.openings.size(), 1u) << "those that it had stay";
  detection.setInputCloud(scene.cloud);
  for (PlanRoom& room : scene.plan.rooms)
    room.floor = sedr_test::slabAt(room.ceiling.heightAt({0, 0}) + 0.05);
  EXPECT_FALSE(detection.segment(scene.plan));
  EXPECT_EQ(detection.getErrorMessage(), "the floor of room 1 lies above its ceiling");
}

TEST(OpeningDetection, PointsThatAreNotFiniteAreLeftOut)
{
  TwoRooms scene(0.005);
  scene.scanMiddleWall({door});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  scene.cloud->insert(scene.cloud->begin(), 100, pcl::PointXYZ(nan, 1, 1));
  EXPECT_EQ(openingsOf(scene).size(), 1u);
}

} // namespace
} // namespace pcl::sedr

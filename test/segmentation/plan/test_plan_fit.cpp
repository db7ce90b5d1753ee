// SPDX-License-Identifier: BSD-3-Clause
#include "found_niches.h"
#include "two_rooms.h"

#include <pcl/sedr_filters/floorplan_io.h>

#include <algorithm>
#include <limits>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(FitPlan, SeesTheBacksOfDeepNiches)
{
  PlanRoom room = roomOf(rectangle(0.01, 0.01, 5.01, 4.01), 2.6);
  room.niches = {{rectangle(5.01, 1, 5.91, 2.5), slabAt(0.5), slabAt(2)}};
  RoomPoints points(0.04, 0.002);
  PlanEvidence evidence = evidenceOf(points, points.room(room));
  evidence.details.clear();
  const Floorplan plan = planOf(points, evidence);
  ASSERT_EQ(plan.rooms.size(), 1u);
  const std::vector<PlanNiche> niches = nichesOf(points, plan.rooms[0]);
  ASSERT_EQ(niches.size(), 1u);
  EXPECT_LT(cornerError(niches[0].boundary, room.niches[0].boundary), 0.01);
}

TEST(FitPlan, FitsEachRoomToItsOwnFaceOfThePartition)
{
  TwoRooms scene;
  // Points other than ceiling have no room here; they go to the nearest.
  for (const auto* part : {&scene.evidence.floor, &scene.evidence.walls})
    for (const int i : *part)
      scene.evidence.room[static_cast<std::size_t>(i)] = 0;
  for (const bool walls_known : {true, false}) {
    if (!walls_known)
      scene.evidence.walls.clear();
    std::vector<PlanWarning> warnings;
    const Floorplan plan = planOf(scene.points, scene.evidence, &warnings);
    EXPECT_TRUE(warnings.empty());
    ASSERT_EQ(plan.rooms.size(), 2u);
    EXPECT_EQ(plan.rooms[0].id, 3u) << "by increasing number";
    EXPECT_EQ(plan.rooms[1].id, 7u);
    EXPECT_LT(cornerError(plan.rooms[0].boundary, scene.right), 0.003);
    EXPECT_LT(cornerError(plan.rooms[1].boundary, scene.left), 0.003);
    EXPECT_NEAR(plan.rooms[0].ceiling.heightAt({5, 1}), 2.8, 0.001);
    EXPECT_NEAR(plan.rooms[1].ceiling.heightAt({1, 1}), 2.5, 0.001);
  }
}

TEST(FitPlan, ARoomKeepsItsFloorThoughSomeOfItsCeilingIsThatOfTheStoreyAbove)
{
  RoomPoints points(0.05, 0.003);
  const PlanLoop loop = rectangle(0.01, 0.01, 4.01, 3.01);
  PlanEvidence evidence;
  for (const std::uint32_t storey : {1u, 2u})
    addRoom(points, points.room(loop, 2.8 * (storey - 1), 2.8 * storey - 0.3), storey,
            evidence);
  int moved = 0;
  for (const int i : evidence.ceiling)
    if (points[i].z() > 5 && points[i].x() < 0.5F && moved < 100) { // through a hole
      evidence.room[static_cast<std::size_t>(i)] = 1;
      ++moved;
    }
  ASSERT_EQ(moved, 100);
  const Floorplan plan = planOf(points, evidence);
  ASSERT_EQ(plan.rooms.size(), 2u);
  EXPECT_NEAR(plan.rooms[0].floor.heightAt({2, 1}), 0, 0.002);
  EXPECT_NEAR(plan.rooms[0].ceiling.heightAt({2, 1}), 2.5, 0.002);
  EXPECT_NEAR(plan.rooms[1].floor.heightAt({2, 1}), 2.8, 0.002);
}

TEST(FitPlan, AWallSeenFromNextDoorIsNoNiche)
{
  // The left room's face of the partition is hidden along half a metre. Ceiling points
  // labelled as its own are inside the partition, before the other room's face.
  TwoRooms scene;
  const auto isHidden = [&](int i) {
    const Eigen::Vector3f& p = scene.points[i];
    return p.x() > 3.9F && p.x() < 4.05F && p.y() > 1 && p.y() < 1.5F;
  };
  auto& walls = scene.evidence.walls;
  walls.erase(std::remove_if(walls.begin(), walls.end(), isHidden), walls.end());
  for (double y = 1.025; y < 1.5; y += 0.05) {
    scene.evidence.ceiling.push_back(scene.points.point(4.05, y, 2.5));
    scene.evidence.room.push_back(7);
  }
  scene.evidence.all = scene.points.all();
  const Floorplan plan = planOf(scene.points, scene.evidence);
  ASSERT_EQ(plan.rooms.size(), 2u);
  EXPECT_EQ(plan.rooms[1].boundary.elements.size(), 4u);
  EXPECT_LT(cornerError(plan.rooms[1].boundary, scene.left), 0.003);
  EXPECT_LT(cornerError(plan.rooms[0].boundary, scene.right), 0.003);
}

TEST(FitPlan, ARoomThatCannotBeFittedIsAWarningWhileOthersCan)
{
  TwoRooms scene;
  auto& floor = scene.evidence.floor;
  floor.erase(std::remove_if(floor.begin(), floor.end(),
                             [&](int i) { return scene.points[i].x() > 4; }),
              floor.end());
  std::vector<PlanWarning> warnings;
  const Floorplan plan = planOf(scene.points, scene.evidence, &warnings);
  ASSERT_EQ(plan.rooms.size(), 1u);
  EXPECT_EQ(plan.rooms[0].id, 7u);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(sentenceOf(warnings[0]).find("room 3"), std::string::npos);
  EXPECT_NE(sentenceOf(warnings[0]).find("0 floor points"), std::string::npos);
}

TEST(FitPlan, WithoutAnyRoomThereIsAProblem)
{
  TwoRooms scene;
  std::fill(scene.evidence.room.begin(), scene.evidence.room.end(), 0u);
  Fitting fitting;
  setEvidence(scene.points, scene.evidence, fitting);
  Floorplan plan;
  EXPECT_FALSE(fitting.segment(plan));
  EXPECT_TRUE(plan.rooms.empty());
  EXPECT_NE(fitting.getErrorMessage(), "");
}

TEST(FitPlan, APartOfACeilingFarFromTheRestIsToldAndLeftOut)
{
  TwoRooms scene;
  for (const int i : scene.points.slab(rectangle(8.01, 0.01, 9.51, 1.01), 2.8)) {
    scene.evidence.ceiling.push_back(i);
    scene.evidence.room.push_back(3);
  }
  scene.evidence.all = scene.points.all();
  std::vector<PlanWarning> warnings;
  const Floorplan plan = planOf(scene.points, scene.evidence, &warnings);
  ASSERT_EQ(plan.rooms.size(), 2u);
  EXPECT_LT(cornerError(plan.rooms[0].boundary, scene.right), 0.003);
  ASSERT_EQ(warnings.size(), 1u);
  const std::string told = sentenceOf(warnings[0]);
  EXPECT_EQ(told.substr(0, 8), "room 3: ");
  EXPECT_NEAR(std::stod(told.substr(8)), 1.5, 0.1) << told;
  EXPECT_NE(told.find("m2 of ceiling lie apart from the rest"), told.npos);
}

/** A corridor between four rooms, whose partitions are on one line across it: there its
 * ceiling was not seen over 0.5 m. */
TEST(FitPlan, ACorridorGoesOnWhereItsCeilingWasHardlySeen)
{
  RoomPoints points(0.05, 0.003);
  PlanEvidence evidence;
  const PlanLoop corridor = rectangle(0.01, 0.01, 12.01, 1.91);
  RoomParts parts;
  parts.floor = points.slab(corridor, 0);
  parts.ceiling = points.slab(corridor, 2.5, [](double x, double) {
    return x < 5.76 || x > 6.26 || std::abs(x - 6.01) < 0.03;
  });
  for (const PlanElement& wall : corridor.elements)
    parts.walls = joined(parts.walls, points.wall(wall, 0, 2.5));
  addRoom(points, parts, 1, evidence);
  std::uint32_t number = 1;
  for (const double y : {-3.09, 2.01})
    for (const auto& [x0, x1] : {std::pair(0.01, 5.76), std::pair(6.26, 12.01)})
      addRoom(points, points.room(rectangle(x0, y, x1, y + 3), 0, 2.5), ++number,
              evidence);
  const Floorplan plan = planOf(points, evidence);
  ASSERT_EQ(plan.rooms.size(), 5u);
  EXPECT_LT(cornerError(plan.rooms[0].boundary, corridor), 0.01);
  EXPECT_EQ(plan.rooms[0].boundary.elements.size(), 4u);
}

/** Of one wall nothing was seen; the lines of fins at the opposite one part the room.
 */
TEST(FitPlan, AFacadeOfGlassIsWhereTheCeilingEnds)
{
  std::vector<Eigen::Vector2d> corners{{0.01, 8.01}, {0.01, 0.01}};
  for (const double x : {6.01, 14.01})
    for (const auto& [dx, y] : {std::pair(0.0, 0.01), std::pair(0.0, 3.01),
                                std::pair(0.2, 3.01), std::pair(0.2, 0.01)})
      corners.emplace_back(x + dx, y);
  corners.insert(corners.end(), {{20.01, 0.01}, {20.01, 8.01}});
  const PlanLoop hall = polygon(corners);
  RoomPoints points(0.05, 0.003);
  RoomParts parts;
  parts.floor = points.slab(hall, 0);
  parts.ceiling = points.slab(hall, 2.5);
  for (const PlanElement& wall : hall.elements)
    if ((wall.start + wall.end).y() < 16)
      parts.walls = joined(parts.walls, points.wall(wall, 0, 2.5));
  PlanEvidence evidence;
  addRoom(points, parts, 1, evidence);
  std::vector<PlanWarning> warnings;
  const Floorplan plan = planOf(points, evidence, &warnings);
  ASSERT_EQ(plan.rooms.size(), 1u);
  EXPECT_LT(cornerError(plan.rooms[0].boundary, hall), 0.03);
  for (const PlanWarning& warning : warnings)
    EXPECT_NE(warning.kind, WarningKind::CeilingApart) << sentenceOf(warning);
}

TEST(FitPlan, AWallHiddenAlongAMetreGoesOnInItsLine)
{
  TwoRooms scene;
  auto& walls = scene.evidence.walls;
  const auto isHidden = [&](int i) {
    const Eigen::Vector3f& p = scene.points[i];
    return p.x() < 0.05F && p.y() > 1 && p.y() < 2;
  };
  walls.erase(std::remove_if(walls.begin(), walls.end(), isHidden), walls.end());
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud = scene.points.cloud();
  const float gone = std::numeric_limits<float>::quiet_NaN();
  for (std::size_t i = 0; i < cloud->size(); ++i)
    if (isHidden(static_cast<int>(i)) && (*cloud)[i].z > 0.1F && (*cloud)[i].z < 2.4F)
      (*cloud)[i].x = gone;
  Fitting fitting;
  fitting.setInputCloud(cloud);
  fitting.setCeilingIndices(shared(scene.evidence.ceiling));
  fitting.setFloorIndices(shared(scene.evidence.floor));
  fitting.setWallIndices(shared(walls));
  fitting.setRooms(scene.evidence.room);
  Floorplan plan;
  ASSERT_TRUE(fitting.segment(plan)) << fitting.getErrorMessage();
  ASSERT_EQ(plan.rooms.size(), 2u);
  EXPECT_EQ(plan.rooms[1].boundary.elements.size(), 4u);
  EXPECT_LT(cornerError(plan.rooms[1].boundary, scene.left), 0.006);
}

} // namespace

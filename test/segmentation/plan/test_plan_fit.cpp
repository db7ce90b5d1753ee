// SPDX-License-Identifier: BSD-3-Clause
#include "found_niches.h"
#include "sedr_segmentation/src/rooms/room_gaps.h"
#include "two_rooms.h"

#include <pcl/sedr_filters/floorplan_io.h>

#include <limits>
#include <utility>

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
  UnequalRooms scene;
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
  UnequalRooms scene;
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
  UnequalRooms scene;
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
  UnequalRooms scene;
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
  UnequalRooms scene;
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
  const RoomParts parts = points.room(
      roomOf(corridor, 2.5), [](const Eigen::Vector3d&) { return true; },
      [](double x, double) {
        return x < 5.76 || x > 6.26 || std::abs(x - 6.01) < 0.03;
      });
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
  const RoomParts parts = points.room(
      roomOf(hall, 2.5), [](const Eigen::Vector3d& p) { return p.y() < 8; });
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
  UnequalRooms scene;
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

/** Two rooms with a partition of 10 cm between y = 0 and y = 0.1, from x = 0 to x = 2,
 * turned about z. The ceiling of the upper room begins 5 cm behind its face, the lower
 * one's reaches up to the partition. Returns the shares of both faces' points that are
 * of their own rooms: of the upper face, and of the lower one above a height. */
std::pair<double, double>
sharesOfFaces(double degrees, double from)
{
  const Eigen::Vector2d shift(0.013, 0.021); // no face along a line of the grid
  const CellGrid grid(0.05);
  std::vector<RoomGap> gaps;
  const auto addRoom = [&](std::uint32_t room, double low, double high) {
    RoomPoints points(0.0225);
    points.slab(placed(rectangle(0, low, 2, high), degrees, shift), 2.5);
    const CellSet cells(grid, points.view(), points.all());
    for (std::size_t k = 0; k < cells.size(); ++k)
      gaps.push_back({cells[k], room, 0, 2.5F, 0});
  };
  addRoom(1, -1, -0.01);
  addRoom(2, 0.15, 1);
  const RoomGaps rooms(grid, gaps);
  RoomPoints points(0.045, 0.01);
  const auto shareOf = [&](std::uint32_t room, double y, double low) {
    const PlanLoop face = placed({{segment({0.2, y}, {1.8, y})}}, degrees, shift);
    const std::vector<int> all = points.wall(face.elements[0], low, 2.4);
    return static_cast<double>(std::count_if(
               all.begin(), all.end(),
               [&](int i) { return rooms.ownerOf(points[i]).room == room; })) /
           static_cast<double>(all.size());
  };
  return {shareOf(2, 0.1, 0), shareOf(1, 0, from)};
}

TEST(ThinPartition, BothFacesStayApartHoweverItIsTurned)
{
  for (const double from : {0.0, 2.0}) // a wardrobe hides the lower part
    for (double degrees = 0; degrees < 180; degrees += 7.3) {
      const auto [upper, lower] = sharesOfFaces(degrees, from);
      EXPECT_GT(upper, 0.9) << degrees;
      EXPECT_GT(lower, 0.9) << degrees;
    }
}

/** Cells of 0.1 m, x and y from 0 to 3. */
void
addGaps(std::uint32_t room, float low, float high, std::vector<RoomGap>& gaps)
{
  for (int x = 0; x < 30; ++x)
    for (int y = 0; y < 30; ++y)
      gaps.push_back({{x, y}, room, low, high, low});
}

TEST(RoomGaps, RoomsAboveEachOtherOwnTheWallsAtTheirHeights)
{
  std::vector<RoomGap> gaps;
  addGaps(1, 0, 2.8F, gaps);
  addGaps(2, 3.1F, 5.9F, gaps);
  gaps[15 * 30 + 15].high = 5.65F; // seen through a hole in the slab
  const RoomGaps rooms(CellGrid(0.1), gaps);
  for (const float beside : {-0.05F, -0.4F}) // of the wall at x = 0
    for (float z = 0.05F; z < 5.9F; z += 0.1F) {
      const PointOwner owner = rooms.ownerOf({beside, 1.55F, z});
      EXPECT_EQ(owner.room, z < 2.95F ? 1u : 2u) << z;
      EXPECT_FALSE(owner.beyond);
    }
  EXPECT_EQ(rooms.ownerOf({1.55F, 1.55F, 4.F}).room, 1u) << "in the hole";
  EXPECT_EQ(rooms.ownerOf({1.25F, 1.55F, 4.F}).room, 2u) << "beside it";
  EXPECT_EQ(rooms.ownerOf({1, 1, -0.7F}).room, 0u) << "a reflection in the floor";
}

TEST(RoomGaps, WhatIsFartherAwayThanWallsIsBeyond)
{
  std::vector<RoomGap> gaps;
  addGaps(7, 0, 2.5F, gaps);
  const RoomGaps rooms(CellGrid(0.1), gaps);
  EXPECT_TRUE(rooms.ownerOf({-1.F, 1.5F, 1}).beyond);
  EXPECT_EQ(rooms.ownerOf({-1.F, 1.5F, 1}).room, 7u);
  EXPECT_EQ(rooms.ownerOf({-9.F, 1.5F, 1}).room, 0u);
  EXPECT_EQ(rooms.ownerOf({std::nanf(""), 0, 1}).room, 0u);
}

} // namespace

// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include <gtest/gtest.h>
#include <pcl/sedr_filters/impl/refinement.h>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_filters/structure_refinement.h>
#include <pcl/sedr_filters/vertical_hole_repair.h>

#include <map>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

using Structure = pcl::PointCloud<pcl::PointStructure>;

void
label(Structure& cloud, const std::vector<int>& indices, StructureLabel what)
{
  for (const int i : indices) {
    cloud[static_cast<std::size_t>(i)].label = static_cast<std::uint32_t>(what);
    cloud[static_cast<std::size_t>(i)].room = 1;
  }
}

/** A room of 4 m x 3 m x 2.5 m with a round column and a table. The wall at y = 0 has a
 * door from x = 1 to 2 up to 2 m. Points have errors of up to a few centimetres. */
struct FurnishedRoom {
  RoomPoints points;
  std::shared_ptr<Floorplan> plan = std::make_shared<Floorplan>();
  std::vector<int> table;
  Structure::Ptr cloud;

  static bool inDoor(double x, double z) { return x > 1 && x < 2 && z < 2; }

  explicit FurnishedRoom(double noise = 0.01)
      : points(0.05, noise)
  {
    PlanRoom room = roomOf(rectangle(0, 0, 4, 3), 2.5);
    room.columns = {reversed(circle({3, 1.5}, 0.3))};
    table = points.slab(rectangle(1, 1, 2, 2), 0.75);
    const auto isFree = [&](double x, double y) { return room.contains({x, y}); };
    const auto floor = points.slab(room.boundary, 0, isFree);
    const auto ceiling = points.slab(room.boundary, 2.5, isFree);
    std::vector<int> walls =
        points.wall(room.boundary.elements[0], 0, 2.5,
                    [](double s, double z) { return !inDoor(s, z); });
    for (std::size_t e = 1; e < 4; ++e)
      walls = joined(walls, points.wall(room.boundary.elements[e], 0, 2.5));
    const auto column = points.wall(room.columns[0].elements[0], 0, 2.5);
    cloud = points.cloud<pcl::PointStructure>();
    label(*cloud, floor, StructureLabel::Floor);
    label(*cloud, ceiling, StructureLabel::Ceiling);
    label(*cloud, walls, StructureLabel::Wall);
    label(*cloud, column, StructureLabel::Column);
    for (std::size_t i = 0; i < cloud->size(); ++i)
      (*cloud)[i].curvature = static_cast<float>(i);
    plan->rooms.push_back(room);
  }
};

TEST(StructureRefinement, SetsPositionNormalLabelAndRoomAndKeepsTheOtherFields)
{
  const FurnishedRoom room;
  pcl::StructureRefinement<pcl::PointStructure> refinement(true);
  refinement.setInputCloud(room.cloud);
  refinement.setFloorplan(room.plan);
  Structure refined;
  refinement.filter(refined);
  ASSERT_EQ(refinement.getErrorMessage(), "");
  const auto& sources = refinement.getSourceIndices();
  const auto& exact = refinement.getSurfacePoints();
  ASSERT_EQ(refined.size(), sources.size());
  ASSERT_EQ(refined.size(), exact.size());
  for (std::size_t k = 0; k < refined.size(); ++k) {
    const auto& p = refined[k];
    const auto& from = (*room.cloud)[static_cast<std::size_t>(sources[k])];
    ASSERT_EQ(p.getVector3fMap(), exact[k].position.cast<float>());
    ASSERT_EQ(p.getNormalVector3fMap(), exact[k].normal.cast<float>());
    ASSERT_EQ(p.label, from.label);
    ASSERT_EQ(p.room, 1u);
    ASSERT_EQ(p.curvature, from.curvature);
    const Eigen::Vector2d place(p.x, p.y);
    if (p.label == 3) {
      ASSERT_NEAR(room.plan->rooms[0].boundary.distance(place), 0, 1e-6);
      ASSERT_EQ(p.z, from.z);
    }
    if (p.label == 5) {
      ASSERT_NEAR((place - Eigen::Vector2d(3, 1.5)).norm(), 0.3, 1e-6);
      const Eigen::Vector2f out =
          (place - Eigen::Vector2d(3, 1.5)).normalized().cast<float>();
      ASSERT_NEAR(p.normal_x, out.x(), 1e-5);
      ASSERT_NEAR(p.normal_y, out.y(), 1e-5);
    }
    if (p.label == 1) {
      ASSERT_EQ(p.z, 2.5f);
    }
    if (p.label == 2) {
      ASSERT_EQ(p.z, 0.f);
    }
  }
}

TEST(StructureRefinement, PointsOfDetailsLieOnTheirUndersidesAndOnTheRisersOfTheirHoles)
{
  auto plan = std::make_shared<Floorplan>();
  plan->rooms = {roomOf(rectangle(0, 0, 4, 3), 2.5)};
  plan->rooms[0].details = {detailOf(rectangle(1, 0, 4, 3), 2.1)};
  plan->rooms[0].details[0].holes = {reversed(rectangle(2, 1, 3, 2))};
  RoomPoints points;
  for (const auto& [x, z] : {std::pair(1.5, 2.12), {1.02, 2.3}, {1.98, 2.3}})
    points.point(x, 1.5, z);
  const auto cloud = points.cloud<pcl::PointStructure>();
  label(*cloud, points.all(), StructureLabel::Detail);
  pcl::StructureRefinement<pcl::PointStructure> refinement;
  refinement.setInputCloud(cloud);
  refinement.setFloorplan(plan);
  Structure refined;
  refinement.filter(refined);
  ASSERT_EQ(refined.size(), 3u);
  EXPECT_EQ(refined[0].getVector3fMap(), Eigen::Vector3f(1.5F, 1.5F, 2.1F));
  EXPECT_EQ(refined[0].normal_z, -1);
  EXPECT_EQ(refined[1].getVector3fMap(), Eigen::Vector3f(1, 1.5F, 2.3F));
  EXPECT_EQ(refined[1].normal_x, -1) << "towards the higher ceiling";
  EXPECT_EQ(refined[2].getVector3fMap(), Eigen::Vector3f(2, 1.5F, 2.3F));
  EXPECT_EQ(refined[2].normal_x, 1);
}

TEST(StructureRefinement, TakesLabelsAndRoomsForAPointTypeWithoutThem)
{
  const FurnishedRoom room;
  const auto plain = room.points.cloud<pcl::PointXYZ>();
  std::vector<std::uint32_t> labels;
  std::vector<std::uint32_t> rooms;
  for (const auto& p : *room.cloud) {
    labels.push_back(p.label);
    rooms.push_back(p.room);
  }
  pcl::StructureRefinement<pcl::PointXYZ> refinement;
  refinement.setInputCloud(plain);
  refinement.setFloorplan(room.plan);
  pcl::PointCloud<pcl::PointXYZ> refined;
  refinement.filter(refined);
  EXPECT_NE(refinement.getErrorMessage().find("0 labels"), std::string::npos)
      << refinement.getErrorMessage();
  EXPECT_TRUE(refined.empty());

  refinement.setRooms(rooms);
  refinement.setLabels(std::vector<std::uint32_t>(rooms.size(), 0));
  refinement.filter(refined);
  EXPECT_EQ(refinement.getErrorMessage().rfind("none of the 0 labelled points of ", 0),
            0u)
      << refinement.getErrorMessage();

  refinement.setLabels(labels);
  refinement.filter(refined);
  EXPECT_EQ(refinement.getErrorMessage(), "");

  pcl::StructureRefinement<pcl::PointStructure> own;
  own.setInputCloud(room.cloud);
  own.setFloorplan(room.plan);
  Structure same;
  own.filter(same);
  ASSERT_EQ(refined.size(), same.size());
  for (std::size_t i = 0; i < same.size(); ++i)
    ASSERT_EQ(refined[i].getVector3fMap(), same[i].getVector3fMap());
}

/** The points of a furnished room, refined and then repaired. */
struct Repaired {
  Structure::Ptr refined = std::make_shared<Structure>();
  Structure whole;
  pcl::VerticalHoleRepair<pcl::PointStructure> repair{true};

  explicit Repaired(const FurnishedRoom& room, bool keep_openings = false)
  {
    repair.setKeepOpenings(keep_openings);
    pcl::StructureRefinement<pcl::PointStructure> refinement;
    refinement.setInputCloud(room.cloud);
    refinement.setFloorplan(room.plan);
    refinement.filter(*refined);
    repair.setInputCloud(refined);
    repair.setFloorplan(room.plan);
    repair.filter(whole);
    EXPECT_EQ(repair.getErrorMessage(), "");
  }
};

/** The room with its wall at x = 4 tilted by 12 degrees, half of it unseen. */
TEST(VerticalHoleRepair, OfATiltedWallLiesOnItsPlane)
{
  constexpr double step = 0.05;
  const double tilt = 12 * M_PI / 180;
  const auto wallAt = [&](double z) { return 4 - z * std::tan(tilt); };
  for (const double sign : {1.0, -1.0}) {
    const auto xAt = [&](double z) { return sign > 0 ? wallAt(z) : 8 - wallAt(z); };
    FurnishedRoom room;
    auto plan =
        std::make_shared<Floorplan>(Floorplan{{roomOf(rectangle(0, 0, 4, 3), 2.5)}});
    plan->rooms[0].boundary.elements[1].tilt = sign * tilt;
    room.plan = plan;
    RoomPoints points(step, 0.01);
    const auto floor = points.slab(rectangle(0, 0, 4, 3), 0);
    const auto ceiling = points.slab(rectangle(0, 0, xAt(2.5), 3), 2.5);
    std::vector<int> wall;
    for (double z = step / 2; z < 2.5; z += step)
      for (double y = step / 2; y < 1.5; y += step)
        wall.push_back(points.point(xAt(z) + (y < 1 ? 0.02 : -0.02), y, z));
    room.cloud = points.cloud<pcl::PointStructure>();
    label(*room.cloud, floor, StructureLabel::Floor);
    label(*room.cloud, ceiling, StructureLabel::Ceiling);
    label(*room.cloud, wall, StructureLabel::Wall);
    const Repaired result(room);
    EXPECT_EQ(result.refined->size(), points.size());
    const Eigen::Vector3d normal(-std::cos(tilt), 0, -sign * std::sin(tilt));
    std::size_t on_wall = 0;
    std::map<std::uint32_t, std::size_t> count;
    for (const auto& p : result.whole) {
      ++count[p.label];
      EXPECT_GE(p.x, -1e-6f);
      EXPECT_LE(p.x, xAt(p.z) + 1e-6);
      if (p.label != 3 || p.getNormalVector3fMap().x() > -0.5f)
        continue;
      ++on_wall;
      EXPECT_NEAR(p.x, xAt(p.z), 1e-6);
      EXPECT_NEAR((p.getNormalVector3fMap().cast<double>() - normal).norm(), 0, 1e-6);
    }
    EXPECT_EQ(on_wall, 60u * 50u);
    EXPECT_NEAR(static_cast<double>(count[1]), xAt(2.5) * 3 / (step * step), 60);
    EXPECT_EQ(count[2], 80u * 60u);
  }
}

TEST(VerticalHoleRepair, KeepsAnOpeningOfATiltedWall)
{
  Floorplan plan{{roomOf(rectangle(0, 0, 4, 3), 2.5)}};
  plan.rooms[0].id = 1;
  plan.rooms[0].boundary.elements[1].tilt = 12 * M_PI / 180;
  plan.openings.resize(1);
  plan.openings[0].walls = {{1, 1}};
  plan.openings[0].start = {4, 1};
  plan.openings[0].end = {4, 2};
  plan.openings[0].depth = 0.1;
  plan.openings[0].bottom = 1;
  plan.openings[0].top = 2.2;
  const OpeningSpaces openings(plan);
  for (const double z : {1.1, 2.1}) {
    const double x = 4 - z * std::tan(12 * M_PI / 180);
    EXPECT_TRUE(openings.contains({x, 1.5, z})) << z;
    EXPECT_FALSE(openings.contains({x, 0.9, z})) << z;
    EXPECT_TRUE(openings.contains({x, 0.97, z}, 0.05)) << "on its reveal";
    EXPECT_FALSE(openings.contains({4, 1.5, z})) << z;
  }
}

TEST(VerticalHoleRepair, FillsADoorExactlyWhereItIs)
{
  const FurnishedRoom room(0); // the lattice hits the middle of every cell
  const Repaired result(room);
  const auto& repaired = result.repair.getRepairedIndices();
  EXPECT_EQ(repaired.size(), 20u * 40u);
  for (const auto k : repaired) {
    const auto& p = result.whole[static_cast<std::size_t>(k)];
    EXPECT_EQ(p.label, 3u);
    EXPECT_EQ(p.room, 1u);
    EXPECT_EQ(p.y, 0.f);
    EXPECT_TRUE(FurnishedRoom::inDoor(p.x, p.z)) << p.x << ' ' << p.z;
    EXPECT_EQ(p.getNormalVector3fMap(), Eigen::Vector3f(0, 1, 0));
    EXPECT_EQ(p.curvature, 0.f) << "fields that nobody measured are zero";
  }
}

TEST(VerticalHoleRepair, KeepsTheOpeningsOfThePlanIfAsked)
{
  FurnishedRoom room(0);
  room.plan->openings = {
      // the lower half of the hole
      {OpeningKind::Unknown, {}, {}, {1, -0.1}, {2, -0.1}, 0, 1, 0, 0.2}};
  EXPECT_EQ(Repaired(room).repair.getRepairedIndices().size(), 20u * 40u);
  const Repaired result(room, true);
  EXPECT_EQ(result.repair.getRepairedIndices().size(), 20u * 20u);
  for (const auto k : result.repair.getRepairedIndices())
    EXPECT_GT(result.whole[static_cast<std::size_t>(k)].z, 1);
  EXPECT_EQ(result.whole.size() + 20u * 20u, Repaired(room).whole.size());
}

TEST(VerticalHoleRepair, CoversTheRoomOnceAndKeepsTheScannedPoints)
{
  const FurnishedRoom room(0);
  const Repaired result(room);
  std::map<std::uint32_t, std::size_t> count;
  for (const auto& p : result.whole)
    ++count[p.label];
  EXPECT_EQ(count[3], 14u * 20u * 50u);
  // 2 pi 0.3 m are 37.7 cells of 5 cm around, 2.5 m are 50.
  EXPECT_EQ(count[5], 38u * 50u);
  EXPECT_NEAR(static_cast<double>(count[1]), 4800 - M_PI * 36, 5);
  EXPECT_EQ(count[1], count[2]);
  EXPECT_EQ(count.size(), 4u);
  const auto& sources = result.repair.getSourceIndices();
  ASSERT_EQ(sources.size(), result.whole.size());
  for (std::size_t k = 0; k < sources.size(); ++k)
    if (sources[k] >= 0) {
      const auto& from = (*result.refined)[static_cast<std::size_t>(sources[k])];
      ASSERT_EQ(result.whole[k].getVector3fMap(), from.getVector3fMap());
      ASSERT_EQ(result.whole[k].curvature, from.curvature);
    }
}

/** Four points of a floor of 4 m by 3 m. */
Structure::Ptr
floorPoints()
{
  auto cloud = std::make_shared<Structure>();
  for (const float x : {0.5f, 1.5f, 2.5f, 3.5f}) {
    pcl::PointStructure p{};
    p.x = x;
    p.y = 1;
    p.label = static_cast<std::uint32_t>(StructureLabel::Floor);
    p.room = 1;
    cloud->push_back(p);
  }
  return cloud;
}

std::shared_ptr<Floorplan>
planOf(const PlanLoop& boundary)
{
  auto plan = std::make_shared<Floorplan>();
  plan->rooms.push_back(roomOf(boundary, 2.5));
  return plan;
}

TEST(StructureRefinement, LabelsAndRoomsThatAreSetStandForThoseOfThePoints)
{
  pcl::StructureRefinement<pcl::PointStructure> refinement;
  refinement.setInputCloud(floorPoints());
  refinement.setFloorplan(planOf(rectangle(0, 0, 4, 3)));
  refinement.setLabels({2, 1, 2, 2}); // the second of the ceiling, far from it
  refinement.setRooms({1, 1, 2, 1});  // the third of a room without a plan
  Structure refined;
  refinement.filter(refined);
  ASSERT_EQ(refinement.getErrorMessage(), "");
  EXPECT_EQ(refinement.getSourceIndices(), (pcl::Indices{0, 3}));
}

TEST(VerticalHoleRepair, TooManyCellsAreRefusedBeforeTheyAreMade)
{
  pcl::VerticalHoleRepair<pcl::PointStructure> repair(true);
  repair.setInputCloud(floorPoints());
  repair.setFloorplan(planOf(rectangle(0, 0, 4, 3)));
  Structure whole;
  for (const double size : {1e-4, 1e-12, 1e-300, 5e-324}) {
    repair.setGridSize(size);
    repair.filter(whole);
    EXPECT_NE(repair.getErrorMessage().find("at most 2e+08"), std::string::npos)
        << size << ": " << repair.getErrorMessage();
    EXPECT_TRUE(whole.empty());
    EXPECT_EQ(repair.getRemovedIndices()->size(), 4u);
  }
  repair.setGridSize(0.5);
  repair.filter(whole);
  EXPECT_EQ(repair.getErrorMessage(), "");
  EXPECT_FALSE(whole.empty());
}

} // namespace

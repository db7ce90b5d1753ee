// SPDX-License-Identifier: BSD-3-Clause
#include "two_rooms.h"

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Eigen::Vector2d;

/** Fits the plan of points by energy, without a raw scan. */
Floorplan
energyPlan(const RoomPoints& points, const PlanEvidence& evidence)
{
  Fitting fitting;
  fitting.setByEnergy(true);
  setEvidence(points, evidence, fitting);
  Floorplan plan;
  EXPECT_TRUE(fitting.segment(plan)) << fitting.getErrorMessage();
  return plan;
}

Floorplan
energyPlan(const PlanRoom& truth, double noise)
{
  RoomPoints points(0.04, noise);
  const RoomParts parts = points.room(truth);
  return energyPlan(points, evidenceOf(points, parts));
}

TEST(PlanByEnergy, EachRoomEndsAtItsOwnFaceOfThePartition)
{
  const TwoRooms scene;
  const Floorplan plan = energyPlan(scene.points, scene.evidence);
  ASSERT_EQ(plan.rooms.size(), 2u);
  EXPECT_EQ(plan.rooms[0].boundary.elements.size(), 4u);
  EXPECT_EQ(plan.rooms[1].boundary.elements.size(), 4u);
  EXPECT_LT(cornerError(plan.rooms[0].boundary, scene.right), 0.004);
  EXPECT_LT(cornerError(plan.rooms[1].boundary, scene.left), 0.004);
}

TEST(PlanByEnergy, AnArcBetweenWallsIsOneArc)
{
  const PlanLoop truth = placed(bittenRectangle(6, 4, 1.3), 23, {0.01, 0.01});
  const Floorplan plan = energyPlan(roomOf(truth, 2.5), 0.003);
  ASSERT_EQ(plan.rooms.size(), 1u);
  ASSERT_EQ(plan.rooms[0].boundary.elements.size(), truth.elements.size());
  EXPECT_LT(cornerError(plan.rooms[0].boundary, truth), 0.01);
  EXPECT_LT(outlineError(plan.rooms[0].boundary, truth), 0.006);
}

TEST(PlanByEnergy, ARoundColumnIsOneCircle)
{
  PlanRoom truth = roomOf(rectangle(0.01, 0.01, 6.01, 5.01), 2.5);
  truth.columns = {reversed(circle({2, 2}, 0.3))};
  const Floorplan plan = energyPlan(truth, 0.003);
  ASSERT_EQ(plan.rooms.size(), 1u);
  ASSERT_EQ(plan.rooms[0].columns.size(), 1u);
  ASSERT_EQ(plan.rooms[0].columns[0].elements.size(), 1u);
  const PlanElement& e = plan.rooms[0].columns[0].elements[0];
  EXPECT_NEAR(e.radius, 0.3, 0.005);
  EXPECT_LT((e.centre - Vector2d(2, 2)).norm(), 0.005);
  EXPECT_FALSE(e.counter_clockwise);
}

TEST(PlanByEnergy, AWallHiddenAlongAMetreGoesOnInItsLine)
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
  fitting.setByEnergy(true);
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

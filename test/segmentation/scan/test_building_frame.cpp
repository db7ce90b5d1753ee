// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include <gtest/gtest.h>
#include <pcl/sedr_filters/scan_frame.h>
#include <pcl/sedr_segmentation/building.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** Returns the points of a room, 5 cm apart, turned about the origin and shifted by 30
 * m. */
RoomPoints
turned(const pcl::sedr::PlanRoom& plan, const Eigen::Matrix3d& turn, double noise)
{
  RoomPoints room(0.05, noise);
  room.room(plan);
  RoomPoints result;
  for (const int i : room.all()) {
    const Eigen::Vector3d p =
        turn * room[i].cast<double>().eval() + Eigen::Vector3d(30, -20, 5);
    result.point(p.x(), p.y(), p.z());
  }
  return result;
}

/** An L-shaped room, so that no two directions are alike. */
PlanRoom
cornerRoom()
{
  return roomOf(polygon({{0, 0}, {7, 0}, {7, 2.2}, {3, 2.2}, {3, 4.6}, {0, 4.6}}), 2.5);
}

BuildingFrame
frameOf(double degrees, double noise)
{
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(degrees * M_PI / 180, Eigen::Vector3d::UnitZ())
          .toRotationMatrix();
  return findBuildingFrame(turned(cornerRoom(), turn, noise).view());
}

TEST(BuildingFrame, IsThatOfTheBuildingHoweverItIsTurned)
{
  const Eigen::Vector3d shift(30, -20, 5); // see turned()
  for (const double noise : {0.0, 0.005}) {
    const BuildingFrame first = frameOf(0, noise);
    for (const double degrees : {7.0, 30.0, 44.9, 90.0, 123.4, 180.0, 271.0}) {
      SCOPED_TRACE(testing::Message() << degrees << " degrees, noise " << noise);
      const Eigen::AngleAxisd turn(degrees * M_PI / 180, Eigen::Vector3d::UnitZ());
      const BuildingFrame frame = frameOf(degrees, noise);
      for (const Eigen::Vector3d& p :
           {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(7, 0, 0),
            Eigen::Vector3d(0, 4.6, 2.5)})
        EXPECT_LT(
            (frame.toBuilding(turn * p + shift) - first.toBuilding(p + shift)).norm(),
            0.004);
    }
  }
}

TEST(BuildingFrame, StartsAtTheLargestWallNotAtThatWithMostPoints)
{
  const RoomPoints even = turned(cornerRoom(), Eigen::Matrix3d::Identity(), 0);
  RoomPoints uneven = even;
  for (const int i : even.all())
    if (even[i].x() > 36.9F) // the wall of 2.2 m, as if between two voxels
      for (int k = 0; k < 2; ++k)
        uneven.point(even[i].x(), even[i].y(), even[i].z());
  const Eigen::Vector3d origin = findBuildingFrame(even.view()).origin;
  EXPECT_LT((findBuildingFrame(uneven.view()).origin - origin).norm(), 0.004);
}

TEST(BuildingFrame, OfPointsKilometresAwayIsThatWithoutThem)
{
  RoomPoints room = turned(cornerRoom(), Eigen::Matrix3d::Identity(), 0);
  const BuildingFrame frame = findBuildingFrame(room.view());
  for (const double away : {2000, 3000})
    room.point(away, -away, away / 10);
  const BuildingFrame with_strays = findBuildingFrame(room.view());
  EXPECT_EQ(with_strays.rotation, frame.rotation);
  EXPECT_EQ(with_strays.origin, frame.origin);
}

TEST(BuildingFrame, IsUndoneExactly)
{
  const BuildingFrame frame = frameOf(17, 0.005);
  const Eigen::Vector3d p(31.5, -18.25, 6.125);
  EXPECT_LT((frame.toScan(frame.toBuilding(p)) - p).norm(), 1e-12);
  const BuildingFrame back = frame.to(BuildingFrame());
  EXPECT_LT((back.toBuilding(frame.toBuilding(p)) - p).norm(), 1e-12);
  EXPECT_NEAR(back.yaw(), -frame.yaw(), 1e-12);
}

} // namespace

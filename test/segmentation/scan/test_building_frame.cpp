// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/scan/scan_tilt.h"
#include "turned_room.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <pcl/sedr_filters/scan_frame.h>
#include <pcl/sedr_segmentation/building.h>

#include <cmath>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

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

TEST(BuildingFrame, IsUndoneExactly)
{
  const BuildingFrame frame = frameOf(17, 0.005);
  const Eigen::Vector3d p(31.5, -18.25, 6.125);
  EXPECT_LT((frame.toScan(frame.toBuilding(p)) - p).norm(), 1e-12);
  const BuildingFrame back = frame.to(BuildingFrame());
  EXPECT_LT((back.toBuilding(frame.toBuilding(p)) - p).norm(), 1e-12);
  EXPECT_NEAR(back.yaw(), -frame.yaw(), 1e-12);
}

constexpr double degree = M_PI / 180;

Eigen::Matrix3d
about(const Eigen::Vector3d& axis, double degrees)
{
  return Eigen::AngleAxisd(degrees * degree, axis.normalized()).toRotationMatrix();
}

TEST(ScanTilt, IsThatOfTheWallsAndIsTakenOutByALevelling)
{
  const PlanRoom plan = roomOf(rectangle(0, 0, 6, 4), 2.5);
  for (const double noise : {0.0, 0.01})
    for (const double degrees : {0.4, 1.0, 2.0, 2.9, 4.0, 8.0, 25.0})
      for (const Eigen::Vector3d& axis :
           {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0.3, -0.8, 0)}) {
        SCOPED_TRACE(testing::Message() << degrees << " degrees, noise " << noise);
        const Eigen::Matrix3d turn = about(axis, degrees);
        const RoomPoints points = turned(plan, turn, noise);
        const ScanTilt tilt = tiltOf(points.view(), points.all());
        EXPECT_NEAR(tilt.angle / degree, degrees, 0.1);
        EXPECT_EQ(tilt.up, tiltOf(points.view(), points.all(), 3).up);
        EXPECT_GT(tilt.area, 20) << "of 48 square metres of floor and ceiling";
        const Levelling levelling = Levelling::of(tilt.up, {30, -20, 5});
        // A corner of the room, 5 m up.
        const Eigen::Vector3d corner = Eigen::Vector3d(30, -20, 5) + turn.col(2) * 5;
        EXPECT_NEAR((levelling.level(corner) - Eigen::Vector3d(30, -20, 10)).norm(), 0,
                    0.015);
        EXPECT_NEAR((levelling.back(levelling.level(corner)) - corner).norm(), 0, 1e-9);
        EXPECT_NEAR(levelling.angle(), tilt.angle, 1e-9);
        EXPECT_NEAR(levelling.direction(), std::atan2(tilt.up.y(), tilt.up.x()), 1e-9);
      }
}

TEST(ScanTilt, IsThatOfASmallRoomToo)
{
  const PlanRoom plan = roomOf(rectangle(0, 0, 2.5, 2), 2.5);
  for (const double degrees : {1.0, 2.0, 5.0, 10.0}) {
    const RoomPoints points = turned(plan, about({0.6, -0.8, 0}, degrees), 0.005);
    EXPECT_NEAR(tiltOf(points.view(), points.all()).angle / degree, degrees, 0.3);
  }
}

TEST(ScanTilt, WallsOutOfPlumbBetweenLevelSlabsAreNone)
{
  // All walls are tilted by 1.5 degrees in the same direction: the room is sheared.
  RoomPoints room(0.05, 0.003);
  room.room(rectangle(0, 0, 6, 4), 0, 2.5);
  RoomPoints sheared;
  for (const int i : room.all())
    sheared.point(room[i].x() + std::tan(1.5 * degree) * room[i].z(), room[i].y(),
                  room[i].z());
  EXPECT_EQ(tiltOf(sheared.view(), sheared.all()).angle, 0);
}

TEST(ScanTilt, ALevelScanHasNoneAndNorHasNothing)
{
  const RoomPoints points =
      turned(roomOf(rectangle(0, 0, 6, 4), 2.5), about({1, 0, 0}, 0.15), 0.02);
  EXPECT_EQ(tiltOf(points.view(), points.all()).angle, 0);
  EXPECT_EQ(tiltOf(PointView(), {}).angle, 0);
}

TEST(ScanTilt, AWavyGroundHasNone)
{
  RoomPoints ground;
  for (double x = 0; x < 20; x += 0.05)
    for (double y = 0; y < 20; y += 0.05)
      ground.point(x, y, 1.5 * std::sin(0.7 * x) * std::cos(0.5 * y));
  EXPECT_EQ(tiltOf(ground.view(), ground.all()).angle, 0);
}

} // namespace

// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/scan/scan_tilt.h"

#include "turned_room.h"
#include <pcl/sedr_filters/scan_frame.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

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

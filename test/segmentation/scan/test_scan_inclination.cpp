// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/scan/scan_inclination.h"

#include "turned_room.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** A room of 6 m x 4 m x 2.5 m, turned by `degrees` about `axis`, 30 m from the origin.
 */
RoomPoints
turnedRoom(double degrees,
           const Eigen::Vector3d& axis,
           double noise = 0,
           const PlanRoom& plan = roomOf(rectangle(0, 0, 6, 4), 2.5))
{
  const Eigen::AngleAxisd turn(degrees * M_PI / 180, axis.normalized());
  return turned(plan, turn.toRotationMatrix(), noise);
}

TEST(ScanInclination, OfATiltedRoomIsItsAngleAndAxis)
{
  for (const double noise : {0.0, 0.01})
    for (const double degrees : {4.0, 8.0, 25.0})
      for (const Eigen::Vector3d& axis :
           {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0.6, -0.8, 0)}) {
        const RoomPoints points = turnedRoom(degrees, axis, noise);
        const ScanInclination inclination = inclinationOf(points.view(), points.all());
        const Eigen::Vector3d up =
            Eigen::AngleAxisd(degrees * M_PI / 180, axis) * Eigen::Vector3d::UnitZ();
        EXPECT_NEAR(inclination.angle * 180 / M_PI, degrees, 0.2);
        EXPECT_GT(inclination.up.dot(up), std::cos(0.2 * M_PI / 180));
        EXPECT_GT(inclination.area, 20) << "of 48 square metres of floor and ceiling";
      }
}

TEST(ScanInclination, IsTheSameForAnyNumberOfThreads)
{
  // Every block has only a few points of each patch; the others are not finite.
  const RoomPoints room = turnedRoom(7, {0.6, -0.8, 0}, 0.01);
  const auto size = static_cast<int>(room.size());
  constexpr int apart = 40;
  constexpr int stride = 7919; // prime
  RoomPoints points;
  for (int k = 0; k < size; ++k) {
    const Eigen::Vector3d p =
        room[static_cast<int>(std::int64_t{k} * stride % size)].cast<double>();
    points.point(p.x(), p.y(), p.z());
    for (int i = 1; i < apart; ++i)
      points.point(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  }
  const ScanInclination one = inclinationOf(points.view(), points.all(), 1);
  const ScanInclination three = inclinationOf(points.view(), points.all(), 3);
  EXPECT_NEAR(one.angle * 180 / M_PI, 7, 0.2);
  EXPECT_EQ(one.up, three.up);
  EXPECT_EQ(one.angle, three.angle);
  EXPECT_EQ(one.area, three.area);
}

TEST(ScanInclination, AWavyGroundHasNone)
{
  RoomPoints ground;
  for (double x = 0; x < 20; x += 0.05)
    for (double y = 0; y < 20; y += 0.05)
      ground.point(x, y, 1.5 * std::sin(0.7 * x) * std::cos(0.5 * y));
  EXPECT_EQ(inclinationOf(ground.view(), ground.all()).angle, 0);
}

TEST(ScanInclination, AVerticalRoomIsNotTilted)
{
  for (const double degrees : {0.0, 1.0, 2.5}) {
    const RoomPoints points = turnedRoom(degrees, {1, 1, 0}, 0.02);
    EXPECT_EQ(inclinationOf(points.view(), points.all()).angle, 0);
  }
  EXPECT_EQ(inclinationOf(PointView(), {}).angle, 0);
}

TEST(ScanInclination, ASlopingRoofBetweenVerticalWallsIsNone)
{
  PlanRoom attic = roomOf(rectangle(0, 0, 6, 4), 2.5);
  attic.ceiling = slabAt(2.2, 0, std::tan(20 * M_PI / 180));
  const RoomPoints points = turnedRoom(0, {1, 0, 0}, 0, attic);
  EXPECT_EQ(inclinationOf(points.view(), points.all()).angle, 0);
  attic.floor = slabAt(0, 0, std::tan(6 * M_PI / 180)); // a ramp as well
  attic.ceiling = slabAt(2.2, 0, std::tan(6 * M_PI / 180));
  const RoomPoints ramp = turnedRoom(0, {1, 0, 0}, 0, attic);
  EXPECT_EQ(inclinationOf(ramp.view(), ramp.all()).angle, 0);
}

} // namespace

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

/** Returns the rotation that a sentence names. */
Eigen::AngleAxisd
namedTurn(const std::string& sentence)
{
  const std::string option = "-axisangle ";
  const auto at = sentence.find(option);
  double x = 0;
  double y = 0;
  double z = 0;
  double angle = 0;
  if (at == std::string::npos ||
      std::sscanf(sentence.c_str() + at + option.size(), "%lf,%lf,%lf,%lf", &x, &y, &z,
                  &angle) != 4)
    return Eigen::AngleAxisd::Identity();
  return Eigen::AngleAxisd(angle, Eigen::Vector3d(x, y, z).normalized());
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

TEST(ScanInclination, TheTurnThatIsNamedPutsTheScanRight)
{
  const RoomPoints points = turnedRoom(7, {0.6, -0.8, 0});
  const std::string problem = inclinationProblem(points.view(), points.all());
  EXPECT_NE(problem.find("stand at 7.0 degrees to z"), std::string::npos) << problem;
  const Eigen::Vector3d up =
      Eigen::AngleAxisd(7 * M_PI / 180, Eigen::Vector3d(0.6, -0.8, 0)) *
      Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d put = namedTurn(problem) * up;
  EXPECT_GT(put.z(), std::cos(0.1 * M_PI / 180));
}

TEST(ScanInclination, TiltedWallsBecauseAnotherAxisIsUpAreToldFromFloors)
{
  const PlanRoom plan = roomOf(rectangle(0, 0, 8, 6), 2.5);
  RoomPoints room;
  room.room(plan);
  for (const char axis : {'y', 'x'})
    for (const double degrees : {8.0, 25.0, 40.0}) {
      RoomPoints points;
      const Eigen::AngleAxisd turn(degrees * M_PI / 180, Eigen::Vector3d::UnitZ());
      for (const int i : room.all()) {
        const Eigen::Vector3d p = turn * room[i].cast<double>().eval();
        axis == 'y' ? points.point(p.y(), p.z(), p.x())
                    : points.point(p.z(), p.x(), p.y());
      }
      EXPECT_GT(inclinationOf(points.view(), points.all()).angle, 0) << "its walls do";
      const std::string problem = inclinationProblem(points.view(), points.all());
      EXPECT_EQ(problem.rfind(std::string(1, axis) + " seems to be up, not z", 0), 0U)
          << problem;
      const Eigen::Vector3d put =
          namedTurn(problem) *
          (axis == 'y' ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX()).eval();
      EXPECT_GT(put.z(), 0.999) << problem;
    }
}

TEST(ScanInclination, AWavyGroundHasNone)
{
  RoomPoints ground;
  for (double x = 0; x < 20; x += 0.05)
    for (double y = 0; y < 20; y += 0.05)
      ground.point(x, y, 1.5 * std::sin(0.7 * x) * std::cos(0.5 * y));
  EXPECT_EQ(inclinationProblem(ground.view(), ground.all()), "");
}

TEST(ScanInclination, AboutAnAxisOfCoordinatesIsStillATilt)
{
  for (const Eigen::Vector2d& size :
       {Eigen::Vector2d(6, 4), Eigen::Vector2d(4, 6), Eigen::Vector2d(15, 2)})
    for (const Eigen::Vector3d& axis : {Eigen::Vector3d(Eigen::Vector3d::UnitX()),
                                        Eigen::Vector3d(Eigen::Vector3d::UnitY())}) {
      const RoomPoints points =
          turnedRoom(12, axis, 0, roomOf(rectangle(0, 0, size.x(), size.y()), 2.5));
      const std::string problem = inclinationProblem(points.view(), points.all());
      EXPECT_EQ(problem.rfind("the scan is inclined", 0), 0U) << problem;
    }
}

TEST(ScanInclination, OfACorridorThatMayLieOnItsSideBothTurnsAreNamed)
{
  // Its walls are 2.4 m apart and larger than its floor: either y is up, or it is
  // tilted by 20 degrees.
  RoomPoints corridor;
  corridor.room(rectangle(0, 0, 15, 2.4), 0, 2.7);
  RoomPoints points;
  const Eigen::AngleAxisd turn(20 * M_PI / 180, Eigen::Vector3d::UnitY());
  for (const int i : corridor.all()) {
    const Eigen::Vector3f p = corridor[i];
    const Eigen::Vector3d q = turn * Eigen::Vector3d(p.x(), p.z(), p.y());
    points.point(q.x(), q.y(), q.z());
  }
  const std::string problem = inclinationProblem(points.view(), points.all());
  EXPECT_EQ(problem.rfind("the scan is inclined", 0), 0U) << problem;
  EXPECT_NE(problem.find("; or, if y is up, 1,0,0,1.5708"), std::string::npos)
      << problem;
}

TEST(ScanInclination, AVerticalRoomIsNotTilted)
{
  for (const double degrees : {0.0, 1.0, 2.5}) {
    const RoomPoints points = turnedRoom(degrees, {1, 1, 0}, 0.02);
    EXPECT_EQ(inclinationProblem(points.view(), points.all()), "");
  }
  EXPECT_EQ(inclinationProblem(PointView(), {}), "");
}

TEST(ScanInclination, ASlopingRoofBetweenVerticalWallsIsNone)
{
  PlanRoom attic = roomOf(rectangle(0, 0, 6, 4), 2.5);
  attic.ceiling = slabAt(2.2, 0, std::tan(20 * M_PI / 180));
  const RoomPoints points = turnedRoom(0, {1, 0, 0}, 0, attic);
  EXPECT_EQ(inclinationProblem(points.view(), points.all()), "");
  attic.floor = slabAt(0, 0, std::tan(6 * M_PI / 180)); // a ramp as well
  attic.ceiling = slabAt(2.2, 0, std::tan(6 * M_PI / 180));
  const RoomPoints ramp = turnedRoom(0, {1, 0, 0}, 0, attic);
  EXPECT_EQ(inclinationProblem(ramp.view(), ramp.all()), "");
}

} // namespace

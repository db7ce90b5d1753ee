// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include <pcl/sedr_segmentation/scan_lean.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** A room of 6 m x 4 m x 2.5 m, turned by `degrees` about `axis`, 30 m off the origin.
 */
RoomPoints
turnedRoom(double degrees,
           const Eigen::Vector3d& axis,
           double noise = 0,
           const PlanRoom& plan = roomOf(rectangle(0, 0, 6, 4), 2.5))
{
  RoomPoints room(0.05, noise);
  room.room(plan);
  const Eigen::Matrix3d turn(
      Eigen::AngleAxisd(degrees * M_PI / 180, axis.normalized()));
  RoomPoints result;
  for (const int i : room.all()) {
    const Eigen::Vector3d p =
        turn * room[i].cast<double>().eval() + Eigen::Vector3d(30, -20, 5);
    result.point(p.x(), p.y(), p.z());
  }
  return result;
}

TEST(ScanLean, OfALeaningRoomIsItsAngleAndAxis)
{
  for (const double noise : {0.0, 0.01})
    for (const double degrees : {4.0, 8.0, 25.0})
      for (const Eigen::Vector3d& axis :
           {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0.6, -0.8, 0)}) {
        const RoomPoints points = turnedRoom(degrees, axis, noise);
        const ScanLean lean = leanOf(points.view(), points.all());
        const Eigen::Vector3d up =
            Eigen::AngleAxisd(degrees * M_PI / 180, axis) * Eigen::Vector3d::UnitZ();
        EXPECT_NEAR(lean.angle * 180 / M_PI, degrees, 0.2);
        EXPECT_GT(lean.up.dot(up), std::cos(0.2 * M_PI / 180));
        EXPECT_GT(lean.area, 20) << "of 48 square metres of floor and ceiling";
      }
}

TEST(ScanLean, TheTurnThatIsNamedPutsTheScanRight)
{
  const RoomPoints points = turnedRoom(7, {0.6, -0.8, 0});
  const std::string problem = leanProblem(points.view(), points.all());
  EXPECT_NE(problem.find("stand at 7.0 degrees to z"), std::string::npos) << problem;
  const std::string option = "-axisangle ";
  const auto at = problem.find(option);
  ASSERT_NE(at, std::string::npos);
  double x = 0;
  double y = 0;
  double angle = 0;
  ASSERT_EQ(std::sscanf(problem.c_str() + at + option.size(), "%lf,%lf,0,%lf", &x, &y,
                        &angle),
            3);
  const Eigen::Vector3d up =
      Eigen::AngleAxisd(7 * M_PI / 180, Eigen::Vector3d(0.6, -0.8, 0)) *
      Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d put =
      Eigen::AngleAxisd(angle, Eigen::Vector3d(x, y, 0).normalized()) * up;
  EXPECT_GT(put.z(), std::cos(0.1 * M_PI / 180));
}

TEST(ScanLean, AnUprightRoomDoesNotLean)
{
  for (const double degrees : {0.0, 1.0, 2.5}) {
    const RoomPoints points = turnedRoom(degrees, {1, 1, 0}, 0.02);
    EXPECT_EQ(leanProblem(points.view(), points.all()), "");
  }
  EXPECT_EQ(leanProblem(PointView(), {}), "");
}

TEST(ScanLean, ASlopingRoofBetweenUprightWallsIsNone)
{
  PlanRoom attic = roomOf(rectangle(0, 0, 6, 4), 2.5);
  attic.ceiling = slabAt(2.2, 0, std::tan(20 * M_PI / 180));
  const RoomPoints points = turnedRoom(0, {1, 0, 0}, 0, attic);
  EXPECT_EQ(leanProblem(points.view(), points.all()), "");
  attic.floor = slabAt(0, 0, std::tan(6 * M_PI / 180)); // a ramp as well
  attic.ceiling = slabAt(2.2, 0, std::tan(6 * M_PI / 180));
  const RoomPoints ramp = turnedRoom(0, {1, 0, 0}, 0, attic);
  EXPECT_EQ(leanProblem(ramp.view(), ramp.all()), "");
}

} // namespace

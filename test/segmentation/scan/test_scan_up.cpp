// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/scan/scan_up.h"

#include "room_points.h"
#include "tools/box_room.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

UpDoubt
doubtOf(const RoomPoints& points)
{
  return doubtOfUp(points.view(), points.all(), {});
}

RoomPoints
rotated(const RoomPoints& points, const Eigen::Matrix3d& turn)
{
  RoomPoints result;
  for (const int i : points.all()) {
    const Eigen::Vector3d p = turn * points[i].cast<double>().eval();
    result.point(p.x(), p.y(), p.z());
  }
  return result;
}

/** Rooms, each with a table, a cupboard and a doorway. */
RoomPoints
flat()
{
  programs::RoomScan scan;
  scan.addRoom({0, 0, 4, 3, 2.5});
  scan.addRoom({4.13, 0, 5, 4.27, 2.5});
  scan.addRoom({0, 3.11, 3.6, 3.5, 2.5});
  scan.addRoom({3.71, 4.4, 4.5, 3.8, 2.5});
  RoomPoints points;
  for (const auto& p : scan.points)
    points.point(p.x, p.y, p.z);
  return points;
}

/** Returns the rotation that a sentence names. */
Eigen::AngleAxisd
namedTurn(const std::string& sentence)
{
  const std::string axis = "say --up ";
  if (const auto at = sentence.find(axis);
      at != std::string::npos && sentence[at + axis.size()] != 'z') {
    const bool is_negative = sentence[at + axis.size()] == '-';
    const char name = sentence[at + axis.size() + (is_negative ? 1 : 0)];
    return Eigen::AngleAxisd(Eigen::Quaterniond::FromTwoVectors(
        (is_negative ? -1 : 1) * Eigen::Vector3d::Unit(name - 'x'),
        Eigen::Vector3d::UnitZ()));
  }
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

TEST(ScanUp, DoesNotDependOnHowAScanLies)
{
  const auto natsOf = [](double yaw) {
    const Eigen::Matrix3d upside_down =
        (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()))
            .toRotationMatrix();
    return doubtOf(rotated(flat(), upside_down)).nats;
  };
  const double nats = natsOf(0);
  EXPECT_GT(nats, UpDoubt::certain);
  for (const double yaw : {0.1, 0.3, 0.5, 0.7, 1.2})
    EXPECT_NEAR(natsOf(yaw), nats, 0.5) << yaw;
}

TEST(ScanUp, OfAFlatIsToldInEachOfSixDirectionsWithTheTurnThatMendsIt)
{
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  for (const double yaw : {0.0, 0.3})
    for (const int axis : {0, 1, 2})
      for (const int sign : {1, -1}) {
        const Eigen::Vector3d up = sign * Eigen::Vector3d::Unit(axis);
        const Eigen::Matrix3d turn =
            Eigen::Quaterniond::FromTwoVectors(z, up).toRotationMatrix() *
            Eigen::AngleAxisd(yaw, z).toRotationMatrix();
        const UpDoubt doubt = doubtOf(rotated(flat(), turn));
        if (up == z) {
          EXPECT_EQ(doubt.reason, "") << doubt.nats;
          continue;
        }
        EXPECT_TRUE(doubt.isDoubtful()) << doubt.nats;
        EXPECT_TRUE(axis < 2 || !doubt.isInclined()) << doubt.reason;
        const double turned = (namedTurn(doubt.reason) * up).z();
        const bool names_both =
            doubt.reason.find("if it is upside down then") != std::string::npos;
        EXPECT_GT(names_both ? std::abs(turned) : turned, 0.9999) << doubt.reason;
      }
}

TEST(ScanUp, OfAVaultBelowAFloorIsDoubted)
{
  PlanRoom room = roomOf(rectangle(0, 0, 6, 4), 2.5);
  RoomPoints vaulted;
  for (double x = 0.025; x < 6; x += 0.05)
    for (double y = 0.025; y < 4; y += 0.05) {
      vaulted.point(x, y, 0);
      vaulted.point(x, y, 2.2 + 0.2 * y * (4 - y));
    }
  for (const PlanElement& wall : room.boundary.elements)
    vaulted.wall(wall, 0, 2.2);
  EXPECT_FALSE(doubtOf(vaulted).isDoubtful());
  const UpDoubt doubt =
      doubtOf(rotated(vaulted, Eigen::Vector3d(1, -1, -1).asDiagonal()));
  EXPECT_TRUE(doubt.isDoubtful()) << doubt.nats;
  EXPECT_NE(doubt.reason.find("upside down"), std::string::npos) << doubt.reason;
}

TEST(ScanUp, BarsFromWallToWallAreOfACeilingIfTheyLeaveHeadroomThingsAreOfAFloor)
{
  struct Case {
    PlanLoop loop;
    double height; // of the upper side of a thing, or the lower one of a bar
    bool is_told;  // upside down
  };
  const Eigen::Matrix3d turn = Eigen::Vector3d(1, -1, -1).asDiagonal();
  for (const double yaw : {0.0, 0.4})
    for (const Case& thing :
         {Case{rectangle(2.3, 0, 2.6, 4), 2.2, true},     // a beam
          Case{rectangle(0, 3.7, 6, 4), 2.2, true},       // one at a wall
          Case{rectangle(2, 1, 3.5, 1.8), 0.9, true},     // a counter
          Case{rectangle(2.3, 0, 2.6, 4), 1.1, false},    // a parapet
          Case{rectangle(2.3, 0, 3.6, 4), 2.3, false},    // a soffit, or a stage
          Case{rectangle(2, 1, 2.3, 1.3), 0.9, false}}) { // a stool
      RoomPoints room(0.05);
      room.room(rectangle(0, 0, 6, 4), 0, 2.6);
      room.slab(thing.loop, thing.height);
      const RoomPoints upright = rotated(
          room, Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix());
      EXPECT_EQ(doubtOf(upright).reason, "") << thing.height;
      const UpDoubt doubt = doubtOf(rotated(upright, turn));
      EXPECT_EQ(doubt.isDoubtful(), thing.is_told) << thing.height << ' ' << doubt.nats;
    }
}

TEST(ScanUp, DesksFromWallToWallBelowAHighCeilingAreHardlyBeams)
{
  RoomPoints room(0.05);
  room.room(rectangle(0, 0, 9, 5), 0, 4.2);
  for (const double x : {4.0, 6.0})
    room.slab(rectangle(x, 0, x + 0.4, 5), 0.75);
  EXPECT_LT(doubtOf(room).nats, UpDoubt::certain);
}

TEST(ScanUp, OfEmptyRoomsCorridorsAndHallsIsNotDoubted)
{
  for (const Eigen::Vector3d& size :
       {Eigen::Vector3d(6, 4, 2.5), Eigen::Vector3d(20, 1.9, 3.2),
        Eigen::Vector3d(4, 3, 4.4), Eigen::Vector3d(20, 15, 8)}) {
    RoomPoints room(0.05);
    room.room(rectangle(0, 0, size.x(), size.y()), 0, size.z());
    EXPECT_FALSE(doubtOf(room).isDoubtful()) << size.transpose();
  }
  RoomPoints open; // with hardly a ceiling
  const PlanLoop loop = rectangle(0, 0, 5, 4);
  open.slab(loop, 0);
  open.slab(rectangle(0, 0, 1, 1), 2.5);
  for (const auto& wall : loop.elements)
    open.wall(wall, 0, 2.5);
  EXPECT_FALSE(doubtOf(open).isDoubtful());
  RoomPoints wall;
  wall.wall(segment({0, 0}, {4, 0}), 0, 9);
  EXPECT_EQ(doubtOf(wall).reason, "");
  EXPECT_FALSE(doubtOf(flat()).is_in_feet);
  const RoomPoints in_feet = rotated(flat(), Eigen::Matrix3d::Identity() / 0.3048);
  const UpDoubt of_feet = doubtOf(in_feet);
  EXPECT_TRUE(of_feet.is_in_feet);
  EXPECT_FALSE(
      doubtOfUp(in_feet.view(), in_feet.all(), {}, 1, {}, {false, true}).is_in_feet);
  EXPECT_EQ(of_feet.reason, "");
  RoomPoints fine(0.02);
  fine.room(rectangle(0, 0, 4, 3), 0, 2.5);
  const UpDoubt of_room = doubtOf(rotated(fine, Eigen::Matrix3d::Identity() / 0.3048));
  EXPECT_GT(of_room.feet_nats, 0.3) << "by its height, though feet are rare";
  EXPECT_NE(of_room.unit_reason.find("2.5 m in feet"), std::string::npos)
      << of_room.unit_reason;
  EXPECT_LE(doubtOf(fine).feet_nats, 0);
  EXPECT_EQ(doubtOfUp(PointView(), {}, {}).reason, "");
}

TEST(ScanUp, AHallIsInMetresThoughSomeOfItIsAsEvenAsALowRoomInFeet)
{
  // Most of its ceiling is in steps below 4 m, which are no room in feet: 1.2 m.
  RoomPoints hall(0.05);
  const PlanLoop floor = rectangle(0, 0, 12, 8);
  hall.slab(floor, 0);
  for (int k = 0; k < 8; ++k)
    hall.slab(rectangle(k, 0, k + 1, 8), 2.8 + 0.14 * k);
  hall.slab(rectangle(8, 0, 12, 8), 4.5);
  for (const auto& wall : floor.elements)
    hall.wall(wall, 0, 2.8);
  EXPECT_LT(doubtOf(hall).feet_nats, UpDoubt::certain);
}

TEST(ScanUp, OfARoomAsWideAsHighNamesBothAxesThatMayBeUpOrWhereScannersStoodTellsIt)
{
  RoomPoints room(0.05);
  room.room(rectangle(0, 0, 3, 2.8), 0, 10);
  room.slab(rectangle(0, 0, 1.5, 2.8), 9);
  const auto doubtWith = [&](const std::vector<Eigen::Vector3d>& stations) {
    return doubtOfUp(room.view(), room.all(), stations);
  };
  const UpDoubt doubt = doubtWith({});
  EXPECT_TRUE(doubt.isDoubtful()) << doubt.nats;
  EXPECT_NE(doubt.reason.find("y seems to be up, not z"), std::string::npos);
  EXPECT_NE(doubt.reason.find("about as likely, say --up"), std::string::npos)
      << doubt.reason;
  EXPECT_FALSE(doubtWith({{0.3, 0.3, 1.6}, {0.3, 0.3, 1.6}}).isDoubtful());
  const UpDoubt known = doubtWith({{0.3, 1.6, 5}, {0.3, 1.6, 5}});
  EXPECT_EQ(known.reason.rfind("y seems to be up", 0), 0U) << known.reason;
}

TEST(ScanUp, AnInclinedScanIsCertainAndToldFromOneWithTiltedWalls)
{
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  for (const double degrees : {7.0, 25.0})
    for (const Eigen::Vector3d& axis :
         {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0),
          Eigen::Vector3d(0.6, -0.8, 0)}) {
      const Eigen::Matrix3d turn =
          Eigen::AngleAxisd(degrees * M_PI / 180, axis).toRotationMatrix();
      const UpDoubt inclined = doubtOf(rotated(flat(), turn));
      EXPECT_TRUE(inclined.isInclined());
      EXPECT_EQ(inclined.reason.rfind("the scan is inclined", 0), 0U)
          << inclined.reason;
      EXPECT_GT((namedTurn(inclined.reason) * turn * z).z(), 0.999) << inclined.reason;
    }
  for (const double degrees : {8.0, 40.0})
    for (const char axis : {'y', 'x'}) {
      const Eigen::Vector3d up = Eigen::Vector3d::Unit(axis - 'x');
      const Eigen::Matrix3d turn =
          Eigen::AngleAxisd(degrees * M_PI / 180, up).toRotationMatrix() *
          Eigen::Quaterniond::FromTwoVectors(z, up).toRotationMatrix();
      const UpDoubt doubt = doubtOf(rotated(flat(), turn));
      EXPECT_TRUE(doubt.isInclined());
      EXPECT_EQ(doubt.reason.rfind(std::string(1, axis) + " seems to be up", 0), 0U)
          << doubt.reason;
      EXPECT_GT((namedTurn(doubt.reason) * up).z(), 0.999) << doubt.reason;
    }
}

} // namespace

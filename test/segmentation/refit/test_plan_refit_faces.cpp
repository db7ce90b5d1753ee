// SPDX-License-Identifier: BSD-3-Clause
#include "refit_plans.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Eigen::Vector3d;

/** Adds points with a different density or noise. */
void
addPoints(const RoomPoints& more, RoomPoints& points)
{
  for (const int i : more.all())
    points.point(more[i].x(), more[i].y(), more[i].z());
}

TEST(RefitToRaw, OfANarrowFaceAllThatWasSeenCounts)
{
  // The far side of a pilaster, scanned below 1.2 m only and fitted 4 mm off.
  const Corners corners{{0, 0},     {1.5, 0}, {1.5, 0.15}, {1.8, 0.15},
                        {1.8, 0.0}, {4, 0},   {4, 3},      {0, 3}};
  RoomPoints raw(0.02, 0.001);
  raw.room(roomOf(polygon(corners), 2.6), [](const Vector3d& p) {
    return std::abs(p.x() - 1.8) > 0.01 || p.y() > 0.14 || p.z() < 1.2;
  });
  Corners found = corners;
  found[3].x() += 0.004;
  found[4].x() += 0.004;
  Floorplan plan;
  plan.rooms.push_back(roomOf(polygon(found), 2.6));
  setSeen(plan.rooms[0].boundary, 0.003);
  refitToRaw(plan, raw.view());
  EXPECT_LT(cornerError(plan.rooms[0].boundary, polygon(corners)), 0.0005);
}

TEST(RefitToRaw, TheFacesOfAThinPartitionKeepApart)
{
  // 8 cm between the faces, noise of 2 cm: the points of both faces overlap.
  PlanRoom left = roomOf(rectangle(0, 0, 4, 3), 2.6);
  PlanRoom right = roomOf(rectangle(4.08, 0, 8, 3), 2.6, 2);
  RoomPoints raw(0.015, 0.02);
  raw.room(left);
  RoomPoints once_more(0.01, 0.02, 2); // twice as dense on the other side
  once_more.room(right);
  addPoints(once_more, raw);
  Floorplan plan;
  plan.rooms = {roomOf(rectangle(0, 0, 4.006, 3), 2.6),
                roomOf(rectangle(4.07, 0, 8, 3), 2.6, 2)};
  for (auto& room : plan.rooms)
    setSeen(room.boundary, 0.02);
  refitToRaw(plan, raw.view());
  EXPECT_NEAR(plan.rooms[0].boundary.elements[1].pointAt(1.5).x(), 4, 0.0015);
  EXPECT_NEAR(plan.rooms[1].boundary.elements[3].pointAt(1.5).x(), 4.08, 0.0015);
}

TEST(RefitToRaw, AShortFaceIsTurnedWherePointsTellItsDirection)
{
  // A pilaster of 12 cm whose front was fitted with an error of 2 degrees.
  const Corners corners{{0, 0},      {1.5, 0}, {1.5, 0.12}, {1.62, 0.12},
                        {1.62, 0.0}, {4, 0},   {4, 3},      {0, 3}};
  RoomPoints raw(0.005, 0.0005);
  raw.room(roomOf(polygon(corners), 2.6));
  Corners found = corners;
  found[2].y() += 0.002;
  found[3].y() -= 0.002;
  Floorplan plan;
  plan.rooms.push_back(roomOf(polygon(found), 2.6));
  setSeen(plan.rooms[0].boundary, 0.003);
  refitToRaw(plan, raw.view());
  EXPECT_LT(cornerError(plan.rooms[0].boundary, polygon(corners)), 0.0005);
}

TEST(RefitToRaw, RevealsWithinAThinPartitionDoNotDrawItsFaceIn)
{
  // A door takes most of a short wall, so its reveals have far more points than the
  // face. The 10 cm to the next room are five times the noise.
  const double noise = 0.02;
  RoomPoints raw(0.02, noise, 4);
  const PlanRoom closet = roomOf(rectangle(0, 0, 1.6, 1.25), 2.6);
  const auto isOpen = [](double y, double z) {
    return y > 0.25 && y < 0.95 && z < 2.05;
  };
  raw.room(closet,
           [&](const Vector3d& p) { return p.x() > 1e-6 || !isOpen(p.y(), p.z()); });
  raw.room(roomOf(rectangle(-4.1, 0, -0.1, 3), 2.6, 2), [&](const Vector3d& p) {
    return p.x() < -0.1 - 1e-6 || !isOpen(p.y(), p.z());
  });
  RoomPoints reveals(0.008, noise, 2);
  reveals.wall(segment({-0.1, 0.25}, {0, 0.25}), 0, 2.05);
  reveals.wall(segment({0, 0.95}, {-0.1, 0.95}), 0, 2.05);
  addPoints(reveals, raw);
  Floorplan plan;
  plan.rooms = {roomOf(rectangle(-0.004, 0, 1.6, 1.25), 2.6),
                roomOf(rectangle(-4.1, 0, -0.098, 3), 2.6, 2)};
  for (auto& room : plan.rooms)
    setSeen(room.boundary, noise);
  refitToRaw(plan, raw.view());
  EXPECT_NEAR(plan.rooms[0].boundary.elements[3].pointAt(0.6).x(), 0, 0.005);
  EXPECT_NEAR(plan.rooms[1].boundary.elements[1].pointAt(0.6).x(), -0.1, 0.005);
}

TEST(RefitToRaw, RevealsOfAPaneAsWideAsItsWallDoNotDrawTheFaceOut)
{
  // Of the wall 12 cm are left on both sides and 5 cm above: most of the points near
  // it are on jambs and below the lintel.
  const double noise = 0.01;
  RoomPoints raw(0.01, noise, 4);
  const PlanRoom room = roomOf(rectangle(0, 0, 5, 4), 2.6);
  raw.room(room, [](const Vector3d& p) {
    return p.y() > 1e-6 || p.x() < 0.12 || p.x() > 4.88 || p.z() > 2.55;
  });
  raw.wall(segment({0.12, 0}, {0.12, -0.3}), 0, 2.55);
  raw.wall(segment({4.88, 0}, {4.88, -0.3}), 0, 2.55);
  raw.slab(rectangle(0.12, -0.3, 4.88, 0), 2.55);
  Floorplan plan;
  plan.rooms = {room};
  setSeen(plan.rooms[0].boundary, noise);
  refitToRaw(plan, raw.view());
  EXPECT_LT(cornerError(plan.rooms[0].boundary, room.boundary), 0.001);
}

} // namespace

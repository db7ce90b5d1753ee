// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include "sedr_surface/src/overhead/room_faces.h"

#include <pcl/sedr_surface/floorplan_extrusion.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

constexpr double at_1_50 = 0.05; // metres for a millimetre of paper

PlanRoom
roomWith(const std::vector<std::pair<PlanLoop, PlanSlab>>& facets)
{
  PlanRoom room = roomOf(rectangle(0, 0, 8, 4), 2.5);
  for (const auto& [loop, slab] : facets) {
    room.details.push_back(detailOf(loop, 0));
    room.details.back().slab = slab;
    room.details.back().is_facet = true;
  }
  return room;
}

std::size_t
lineCount(const PlanRoom& room)
{
  return surfaceLines(room, SurfaceSide::Ceiling, at_1_50).lines.size();
}

SurfaceLines
ceilingLines(const PlanRoom& room, double finest)
{
  return surfaceLines(room, SurfaceSide::Ceiling, finest);
}

TEST(CeilingLines, AreWhereThereIsAStepOrAnAngle)
{
  const auto withStep = [](double step) {
    return roomWith({{rectangle(4, 0, 8, 4), slabAt(2.5 + step)}});
  };
  EXPECT_EQ(lineCount(withStep(0.02)), 0u);
  EXPECT_EQ(lineCount(withStep(0.04)), 1u);
  EXPECT_EQ(lineCount(withStep(-0.04)), 1u);
  const auto withAngle = [](double degrees) {
    const double slope = std::tan(degrees * M_PI / 180);
    return roomWith({{rectangle(4, 0, 8, 4), slabAt(2.5 - 4 * slope, slope)}});
  };
  EXPECT_EQ(lineCount(withAngle(5)), 0u);
  EXPECT_EQ(lineCount(withAngle(7)), 1u);
}

TEST(CeilingLines, OfAThingThatIsTinyOnPaperAreNone)
{
  const PlanRoom room = roomWith({{rectangle(4, 1, 4.25, 1.25), slabAt(2.2)}});
  EXPECT_EQ(ceilingLines(room, at_1_50).lines.size(), 0u);
  EXPECT_EQ(ceilingLines(room, 0.02).lines.size(), 4u);
}

TEST(CeilingLines, TwoPlanesMeetInARidge)
{
  const auto lines =
      ceilingLines(roomWith({{rectangle(0, 0, 8, 4), slabAt(1.3, 0.3)},
                             {rectangle(4, 0, 8, 4), slabAt(4.9, -0.6)}}),
                   at_1_50)
          .lines;
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].is_crease);
  EXPECT_EQ(lines[0].text, "ridge 2.50");
  EXPECT_NEAR(lines[0].element.start.x(), 4, 1e-6);
  EXPECT_NEAR(lines[0].element.end.x(), 4, 1e-6);
  EXPECT_NEAR(lines[0].element.length(), 4, 0.01);
}

TEST(CeilingLines, AStepStaysWhereItIs)
{
  // A riser of 20 cm, then a slope of 30 degrees.
  const auto lines =
      ceilingLines(roomWith({{rectangle(4, 0, 8, 4), slabAt(2.7 - 2.3, 0.577)}}),
                   at_1_50)
          .lines;
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_FALSE(lines[0].is_crease);
  EXPECT_NEAR(lines[0].element.start.x(), 4, 1e-6);
}

/** A roof with four slopes, whose ridge runs along y = 2. */
PlanRoom
hippedRoom(double slope)
{
  PlanRoom room = roomWith(
      {{polygon({{0, 4}, {2, 2}, {6, 2}, {8, 4}}), slabAt(1 + 4 * slope, 0, -slope)},
       {polygon({{0, 0}, {2, 2}, {0, 4}}), slabAt(1, slope)},
       {polygon({{8, 0}, {8, 4}, {6, 2}}), slabAt(1 + 8 * slope, -slope)}});
  room.ceiling = slabAt(1, 0, slope);
  return room;
}

TEST(CeilingLines, OfAHippedRoofAreARidgeAndFourHips)
{
  const auto lines = ceilingLines(hippedRoom(0.7), at_1_50).lines;
  ASSERT_EQ(lines.size(), 5u);
  std::size_t ridges = 0;
  for (const SurfaceLine& line : lines) {
    EXPECT_TRUE(line.is_crease);
    ridges += line.text == "ridge 2.40" ? 1 : 0;
    EXPECT_NEAR(line.element.length(), line.text.empty() ? std::sqrt(8) : 4, 0.08);
  }
  EXPECT_EQ(ridges, 1u);
}

TEST(HeightLines, EndAtSoffitsAndPlatforms)
{
  // A slope from 1 to 3 m, and a soffit of 1.5 m across a part of it: the line of 2 m
  // ends there. So it does at a platform.
  PlanRoom room = roomOf(rectangle(0, 0, 4, 4), 0);
  room.ceiling = slabAt(1, 0.5);
  room.details = {detailOf(rectangle(0, 0, 4, 1), 1.5)};
  room.floor_details = {detailOf(rectangle(0, 3, 4, 4), 0.2)};
  double length = 0;
  for (const auto& [line, is_crease, text] : heightLines(RoomFaces(room), 2)) {
    EXPECT_NEAR(line.start.x(), line.end.x(), 1e-6);
    const bool is_above_platform = line.pointAt(line.length() / 2).y() > 3;
    EXPECT_NEAR(line.start.x(), is_above_platform ? 2.4 : 2, 1e-6);
    length += line.length();
  }
  EXPECT_NEAR(length, 3, 1e-3);
}

TEST(ContourLines, RunAroundADomeAtEqualHeights)
{
  PlanRoom room = roomOf(circle({3, 2}, 2), 0);
  SlabCurve dome;
  dome.kind = CurveKind::Ellipsoid;
  dome.centre = {3, 2};
  dome.base = 2;
  dome.along = dome.across = dome.up = 2;
  room.ceiling.curve = std::make_shared<SlabCurve>(dome);
  const auto lines = contourLines(RoomFaces(room));
  std::map<long, int> told;
  for (const SurfaceLine& line : lines) {
    const Eigen::Vector2d p = line.element.start - Eigen::Vector2d(3, 2);
    const long quarter = std::lround(4 * (2 + std::sqrt(4 - p.squaredNorm())));
    EXPECT_NEAR(std::hypot(p.norm(), 0.25 * quarter - 2), 2, 0.001);
    if (!line.text.empty()) {
      EXPECT_EQ(std::stod(line.text), 0.25 * quarter);
      ++told[quarter];
    }
  }
  EXPECT_EQ(told.size(), 7u) << "2.25 to 3.75, one of them along a ring of corners";
  for (const auto& [height, count] : told)
    EXPECT_EQ(count, 1) << height;
}

} // namespace

// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include "sedr_surface/src/overhead/ceiling_faces.h"

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

TEST(CeilingLines, BordersAreDrawnWholeOrNotAtAll)
{
  // From 0 to 10 cm over 4 m: 3 cm and more on the last 2.8 m; to 5 cm, on 1.6 m.
  for (const double slope : {0.025, 0.0125}) {
    const auto found = ceilingLines(
        roomWith({{rectangle(4, 0, 8, 4), slabAt(2.5, 0, slope)}}), at_1_50);
    ASSERT_EQ(found.lines.size(), slope > 0.02 ? 1u : 0u);
    EXPECT_EQ(found.part[0] == found.part[1], found.lines.empty());
    for (const SurfaceLine& line : found.lines)
      EXPECT_NEAR(line.element.length(), 4, 0.001);
  }
}

TEST(CeilingLines, EndNowhereWithinAPart)
{
  // A step of 5 cm, x = 6, ends where a ramp leads from the main ceiling up beside it.
  const PlanRoom room = roomWith({{rectangle(0, 2, 6, 4), slabAt(2.5, 0.05 / 6)},
                                  {rectangle(6, 0, 8, 4), slabAt(2.55)}});
  for (const SurfaceLine& line : ceilingLines(room, at_1_50).lines)
    ADD_FAILURE() << line.element.start.transpose() << " to "
                  << line.element.end.transpose();
}

TEST(CeilingLines, OfAThingThatIsTinyOnPaperAreNone)
{
  const PlanRoom room = roomWith({{rectangle(4, 1, 4.25, 1.25), slabAt(2.2)}});
  EXPECT_EQ(ceilingLines(room, at_1_50).lines.size(), 0u);
  EXPECT_EQ(ceilingLines(room, 0.02).lines.size(), 4u);
}

TEST(CeilingLines, FacetsWithoutALineAreOnePart)
{
  const auto found = ceilingLines(roomWith({{rectangle(4, 0, 6, 4), slabAt(2.2)},
                                            {rectangle(6, 0, 8, 4), slabAt(2.21)}}),
                                  at_1_50);
  EXPECT_EQ(found.lines.size(), 1u);
  EXPECT_NE(found.part[0], found.part[1]);
  EXPECT_EQ(found.part[1], found.part[2]);
}

TEST(CeilingLines, AreTheEdgesOfSoffitsInTheRoom)
{
  PlanRoom room = roomOf(rectangle(0, 0, 6, 4), 2.5);
  room.details = {detailOf(rectangle(4, -1, 7, 5), 2.2)};
  const auto soffit = ceilingLines(room, at_1_50).lines;
  ASSERT_EQ(soffit.size(), 1u);
  EXPECT_NEAR(soffit[0].element.length(), 4, 0.001);
  room.details = {detailOf(circle({6, 2}, 1), 2.2)};
  const auto round = ceilingLines(room, at_1_50).lines;
  ASSERT_EQ(round.size(), 1u);
  EXPECT_EQ(round[0].element.radius, 1);
  EXPECT_NEAR(round[0].element.length(), M_PI, 0.001);
}

TEST(CeilingLines, TwoPlanesMeetInTheirIntersection)
{
  // They do so along x = 4; their border is up to 2 cm beside that.
  Corners border{{8, 0}, {8, 4}};
  for (int k = 0; k <= 16; ++k)
    border.emplace_back(k % 3 == 0 ? 4.02 : 3.98, 4 - 0.25 * k);
  const auto lines = ceilingLines(roomWith({{rectangle(0, 0, 8, 4), slabAt(1.3, 0.3)},
                                            {polygon(border), slabAt(4.9, -0.6)}}),
                                  at_1_50)
                         .lines;
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].is_crease);
  EXPECT_EQ(lines[0].text, "ridge 2.50");
  EXPECT_NEAR(lines[0].element.start.x(), 4, 1e-6);
  EXPECT_NEAR(lines[0].element.end.x(), 4, 1e-6);
  EXPECT_NEAR(lines[0].element.length(), 4, 0.01);
}

TEST(CeilingLines, SlopesOfMoreThan45DegreesMeetInARidge)
{
  for (const double slope : {0.9, 1.1, 2.0}) {
    const double ridge = 1 + 2 * slope;
    const auto lines =
        ceilingLines(roomWith({{rectangle(0, 0, 8, 2.01), slabAt(1, 0, slope)},
                               {rectangle(0, 2.01, 8, 4),
                                slabAt(ridge + 2 * slope, 0, -slope)}}),
                     at_1_50)
            .lines;
    ASSERT_EQ(lines.size(), 1u) << slope;
    EXPECT_TRUE(lines[0].is_crease) << slope;
    EXPECT_NEAR(lines[0].element.start.y(), 2, 1e-6) << slope;
    EXPECT_EQ(lines[0].text.substr(0, 6), "ridge ") << slope;
  }
}

TEST(CeilingLines, AStepStaysWhereItIs)
{
  // A riser of 20 cm, then a slope of 30 degrees: they would meet elsewhere.
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

TEST(CeilingHeights, OfARoofAreThoseOfEavesAndRidge)
{
  const PlanRoom room = hippedRoom(0.7);
  EXPECT_NEAR(heightRange(CeilingFaces(room)).first, 1, 1e-6);
  EXPECT_NEAR(heightRange(CeilingFaces(room)).second, 2.4, 1e-6);
  for (const PlanElement& wall : room.boundary.elements)
    EXPECT_EQ(eavesText(room, wall), "eaves 1.00");
}

TEST(CeilingHeights, AreNotThoseOfAThing)
{
  PlanRoom room = hippedRoom(0.7);
  room.details.push_back(detailOf(rectangle(3, 1.5, 3.4, 1.9), 0.5)); // of 32 m2
  EXPECT_NEAR(heightRange(CeilingFaces(room)).first, 1, 1e-6);
}

TEST(HeightLines, RunAroundARoof)
{
  // Slopes of 45 degrees: half a metre from the walls.
  const PlanRoom hipped = hippedRoom(1);
  double length = 0;
  for (const SurfaceLine& line : heightLines(CeilingFaces(hipped), 1.5))
    length += line.element.length();
  EXPECT_NEAR(length, 20, 1e-6);
  EXPECT_TRUE(heightLines(CeilingFaces(hipped), 3.5).empty());
  const PlanRoom level = roomOf(rectangle(0, 0, 8, 4), 2.5);
  EXPECT_TRUE(heightLines(CeilingFaces(level), 1.5).empty());
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
  for (const auto& [line, is_crease, text] : heightLines(CeilingFaces(room), 2)) {
    EXPECT_NEAR(line.start.x(), line.end.x(), 1e-6);
    const bool is_above_platform = line.pointAt(line.length() / 2).y() > 3;
    EXPECT_NEAR(line.start.x(), is_above_platform ? 2.4 : 2, 1e-6);
    length += line.length();
  }
  EXPECT_NEAR(length, 3, 1e-3);
}

TEST(HeightLines, FollowAVault)
{
  // A barrel of 2 m that starts 1 m up.
  PlanRoom room = roomOf(rectangle(0, 0, 6, 4), 0);
  SlabCurve vault;
  vault.centre = {0, 2};
  vault.base = 1;
  vault.across = vault.up = 2;
  room.ceiling.curve = std::make_shared<SlabCurve>(vault);
  const auto lines = heightLines(CeilingFaces(room), 2);
  ASSERT_EQ(lines.size(), 2u);
  for (const SurfaceLine& line : lines)
    EXPECT_NEAR(std::abs(line.element.pointAt(3).y() - 2), std::sqrt(3), 0.002);
}

TEST(FloorLines, AreWhereTheFloorHasAStepOrARamp)
{
  // A platform of 2 and of 4 cm, then a ramp of 8 % up to one of 20 cm.
  PlanRoom room = roomOf(rectangle(0, 0, 8, 4), 2.5);
  const auto count = [&](double step) {
    room.floor_details = {detailOf(rectangle(6, 0, 8, 4), step)};
    return surfaceLines(room, SurfaceSide::Floor, at_1_50).lines.size();
  };
  EXPECT_EQ(count(0.02), 0u);
  EXPECT_EQ(count(0.04), 1u);
  EXPECT_EQ(count(0.2), 1u);
  PlanDetail ramp = detailOf(rectangle(3.5, 0, 6, 4), 0);
  ramp.slab = slabAt(-0.08 * 3.5, 0.08);
  room.floor_details.push_back(ramp);
  EXPECT_EQ(surfaceLines(room, SurfaceSide::Floor, at_1_50).lines.size(), 2u);
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
  const auto lines = contourLines(CeilingFaces(room));
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

TEST(CeilingFaces, HaveTheAreaOfTheSolid)
{
  PlanRoom room = roomWith({{rectangle(4, 0, 8, 4), slabAt(2.5 - 4, 1)}});
  const CeilingFaces ceiling(room);
  EXPECT_NEAR(ceiling.area(0), 16, 1e-6);
  EXPECT_NEAR(ceiling.area(1), 16 * std::sqrt(2), 1e-6);
  TriangleMesh solid;
  std::vector<SolidElement> elements;
  EXPECT_NEAR(ceiling.area(), extrudeRoom(room, {}, solid, elements).ceiling_area,
              1e-6);
}

} // namespace

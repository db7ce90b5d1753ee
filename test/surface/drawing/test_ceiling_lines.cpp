// SPDX-License-Identifier: BSD-3-Clause
// Lines of ceilings in drawings.
#include "drawn_plans.h"

#include <gtest/gtest.h>
#include <pcl/sedr_surface/floorplan_drawing.h>

#include <algorithm>
#include <memory>

namespace {

using namespace sedr_test;

constexpr double degree = M_PI / 180;

struct Facet {
  PlanLoop loop;
  PlanSlab slab;
};

Floorplan
roomBelow(const PlanSlab& ceiling, const std::vector<Facet>& facets)
{
  Floorplan plan = planOf(rectangle(0, 0, 8, 4));
  plan.rooms[0].ceiling = ceiling;
  for (const auto& [loop, slab] : facets) {
    plan.rooms[0].details.push_back(detailOf(loop, 0));
    plan.rooms[0].details.back().slab = slab;
    plan.rooms[0].details.back().is_facet = true;
  }
  return plan;
}

TEST(CeilingLines, AreWhereThereIsAStepOrAnAngleUnlessItIsTinyOnPaper)
{
  const PlanSlab level = slabAt(2.5);
  const PlanLoop half = rectangle(4, 0, 8, 4);
  const PlanLoop tile = rectangle(4, 1, 4.25, 1.25);
  const auto angled = [](double degrees) {
    const double slope = std::tan(degrees * degree);
    return slabAt(2.5 - 4 * slope, slope);
  };
  const Floorplan hipped =
      roomBelow(slabAt(1, 0, 0.7),
                {{polygon({{0, 4}, {2, 2}, {6, 2}, {8, 4}}), slabAt(3.8, 0, -0.7)},
                 {polygon({{0, 0}, {2, 2}, {0, 4}}), slabAt(1, 0.7)},
                 {polygon({{8, 0}, {8, 4}, {6, 2}}), slabAt(6.6, -0.7)}});
  struct Case {
    const char* what;
    Floorplan plan;
    double steps; ///< length of their lines, metres
    double creases;
  };
  for (const Case& c : std::vector<Case>{
           {"2 cm", roomBelow(level, {{half, slabAt(2.52)}}), 0, 0},
           {"4 cm", roomBelow(level, {{half, slabAt(2.54)}}), 4, 0},
           {"4 cm down", roomBelow(level, {{half, slabAt(2.46)}}), 4, 0},
           {"5 degrees", roomBelow(level, {{half, angled(5)}}), 0, 0},
           {"7 degrees", roomBelow(level, {{half, angled(7)}}), 0, 4},
           {"a riser below a slope", roomBelow(level, {{half, slabAt(0.4, 0.577)}}), 4,
            0},
           {"a gable", roomBelow(slabAt(1.3, 0.3), {{half, slabAt(4.9, -0.6)}}), 0, 4},
           {"a ridge and four hips", hipped, 0, 4 + 4 * std::sqrt(8)}}) {
    const std::string dxf = dxfOf(c.plan, ofCeiling());
    EXPECT_NEAR(lineLength("A-CLNG", dxf), c.steps, 0.1) << c.what;
    EXPECT_NEAR(lineLength("A-CLNG-RIDG", dxf), c.creases, 0.32) << c.what;
  }
  const Floorplan tiny = roomBelow(level, {{tile, slabAt(2.2)}});
  for (const double scale : {20.0, 50.0}) {
    const auto lines = PlanDrawing(tiny, ofCeiling(scale), 0).lines;
    const auto count = std::count_if(lines.begin(), lines.end(), [](const auto& line) {
      return line.layer == PlanLayer::Ceiling;
    });
    EXPECT_EQ(count > 0, scale < 50) << scale;
  }
  EXPECT_NEAR(lineLength("A-CLNG", dxfOf(tiny, ofCeiling())), 1, 1e-3);
  EXPECT_TRUE(says(svgOf(hipped, ofCeiling()), ">ridge 2.40<"));
}

TEST(CeilingLines, OfAHeadroomEndAtSoffitsAndPlatforms)
{
  // A slope from 1 to 3 m, and a soffit of 1.4 m across a part of it.
  Floorplan plan = planOf(rectangle(0, 0, 4, 4));
  plan.rooms[0].ceiling = slabAt(1, 0.5);
  EXPECT_NEAR(lineLength("A-CLNG-HEAD", dxfOf(plan)), 2 * 4, 1e-3);
  plan.rooms[0].details = {detailOf(rectangle(0, 0, 4, 1), 1.4)};
  EXPECT_NEAR(lineLength("A-CLNG-HEAD", dxfOf(plan)), 2 * 3, 1e-3);
  plan.rooms[0].floor_details = {detailOf(rectangle(0, 3, 4, 4), 0.2)};
  EXPECT_NEAR(lineLength("A-CLNG-HEAD", dxfOf(plan)), 2 * 3, 1e-3);
  // At a headroom of 1.5 and 2.3 m, above the floor or the platform.
  const auto lines = PlanDrawing(plan, {}, 0).lines;
  for (const double x : {1.0, 1.4, 2.6, 3.0})
    EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [x](const auto& line) {
      return line.layer == PlanLayer::Headroom &&
             std::abs(line.element.start.x() - x) < 1e-3;
    })) << x;
}

TEST(CeilingLines, OfEqualHeightRunAroundADome)
{
  Floorplan plan = planOf(circle({3, 2}, 2));
  SlabCurve dome;
  dome.kind = CurveKind::Ellipsoid;
  dome.centre = {3, 2};
  dome.base = 2;
  dome.along = dome.across = dome.up = 2;
  plan.rooms[0].ceiling = PlanSlab();
  plan.rooms[0].ceiling.curve = std::make_shared<SlabCurve>(dome);
  double length = 0;
  const std::string svg = svgOf(plan, ofCeiling(10));
  for (double up = 0.25; up < 2; up += 0.25) {
    length += 2 * M_PI * std::sqrt(4 - up * up);
    EXPECT_TRUE(says(svg, ">" + std::to_string(2 + up).substr(0, 4) + "<")) << up;
  }
  EXPECT_NEAR(lineLength("A-CLNG-CNTR", dxfOf(plan, ofCeiling())), length,
              0.01 * length);
}

} // namespace

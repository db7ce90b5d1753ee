// SPDX-License-Identifier: BSD-3-Clause
#include "drawn_plans.h"

#include "sedr_filters/src/base/number_text.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/floorplan_drawing.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

DrawingSettings
ofCeiling()
{
  DrawingSettings settings;
  settings.view = DrawingView::Ceiling;
  settings.scale = 50;
  return settings;
}

TEST(CeilingPlan, HasTheHeightsAndAreasOfTheSolid)
{
  // A beam and a coffer, a roof, and a barrel vault.
  Floorplan plan = planOf(rectangle(0, 0, 8, 6));
  plan.rooms[0].details = {detailOf(rectangle(0, 4, 8, 4.4), 2.2),
                           detailOf(rectangle(2, 1, 6, 3), 2.76)};
  plan.rooms.push_back(roomOf(rectangle(9, 0, 15, 6), 0, 2));
  plan.rooms[1].ceiling = slabAt(2 - 9 * 0.5, 0.5);
  plan.rooms.push_back(roomOf(rectangle(16, 0, 22, 6), 0, 3));
  SlabCurve vault;
  vault.centre = {16, 3};
  vault.base = 2;
  vault.across = vault.up = 3;
  plan.rooms[2].ceiling.curve = std::make_shared<SlabCurve>(vault);
  const std::string svg = svgOf(plan, ofCeiling());
  double area = 0;
  for (const PlanRoom& room : plan.rooms) {
    TriangleMesh solid;
    std::vector<SolidElement> elements;
    const double of_room = extrudeRoom(room, {}, solid, elements).ceiling_area;
    EXPECT_TRUE(holds(svg, ">ceiling " + decimalText(of_room, 2) + " m²<"));
    area += of_room;
  }
  EXPECT_TRUE(holds(svg, ">3 rooms, " + decimalText(area, 2) + " m²<"));
  for (const char* text : {">2.50<", ">2.20<", ">2.76<", ">26.6°<", ">eaves 2.00<",
                           ">h 2.00 - 5.00 m<", ">3.50<", ">Reflected ceiling plan<"})
    EXPECT_TRUE(holds(svg, text)) << text;
  const std::string dxf = dxfOf(plan, ofCeiling());
  EXPECT_NEAR(outlinedArea(dxf), 48 + 36 + 36, 1e-3) << "faces of the solid in plan";
  EXPECT_EQ(countOf(dxf, "LINE", "A-CLNG"), 2u + 4u);
  EXPECT_EQ(countOf(dxf, "LINE", "A-CLNG-CNTR"), 2 * 5u) << "2.50 to 4.50";
  EXPECT_EQ(countOf(dxf, "LINE", "A-CLNG-SLPE"), 3u);
}

TEST(CeilingPlan, TheWallGoesOnAboveOpeningsButThoseUpToTheCeiling)
{
  Floorplan plan = planOf(rectangle(0, 0, 8, 6));
  for (const double top : {2.0, 2.5}) {
    plan.openings = {
        {OpeningKind::Door, {1, 0}, {{1, 0}}, {3, -0.1}, {2, -0.1}, 0, top, 0, 0.2}};
    const PlanDrawing drawing(plan, ofCeiling(), 0);
    ASSERT_EQ(drawing.openings.size(), 1u);
    EXPECT_EQ(linesOf(drawing.openings[0]).size(), top < 2.5 ? 4u : 2u);
  }
}

} // namespace

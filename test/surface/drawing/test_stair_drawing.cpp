// SPDX-License-Identifier: BSD-3-Clause
#include "drawn_plans.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/floorplan_drawing.h>

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace sedr_test;

/** Two storeys with a flight of 16 steps along x; the riser of 0.175 * 7 m is above the
 * cut. */
Floorplan
storeysWithFlight()
{
  Floorplan plan = twoStoreys(0);
  plan.storeys = {{1, "ground", 0, 0, {1, 2}}, {2, "attic", 0, 0, {3, 4}}};
  PlanFlight flight;
  flight.rise = 0.175;
  for (int k = 0; k < 16; ++k)
    flight.risers.push_back(
        {Eigen::Vector2d(4.5 + 0.25 * k, 1.5), Eigen::Vector2d(4.5 + 0.25 * k, 0.5)});
  plan.stairs = {{{2, 4}, {6, 0.5}, 0, 2.8, {flight}}};
  return plan;
}

TEST(StairDrawing, AFlightIsCutOnTheLowerStoreyOnly)
{
  const Floorplan plan = storeysWithFlight();
  const auto storeys = storeysOf(plan);
  for (std::size_t s = 0; s < 2; ++s) {
    const PlanDrawing drawing(plan, sheetOf(storeys[s]), 0);
    std::size_t treads = 0;
    std::size_t slanted = 0;
    for (const PlanLine& line : drawing.lines) {
      const Eigen::Vector2d way = line.element.end - line.element.start;
      if (line.layer != PlanLayer::Stair || line.element.isArc())
        continue;
      treads += std::abs(way.x()) < 1e-9 ? 1 : 0;
      slanted += std::abs(way.x()) > 1e-9 && std::abs(way.y()) > 1e-9 ? 1 : 0;
    }
    EXPECT_EQ(treads, s == 0 ? 7u : 16u) << "up to the break line";
    EXPECT_EQ(slanted, s == 0 ? 4u : 2u) << "arrow and break lines";
  }
  EXPECT_TRUE(holds(dxfOf(plan, sheetOf(storeys[0])), "A-FLOR-STRS\n"));
}

TEST(StairDrawing, OfAFlightOnlyWhatLiesBesideTheOneAboveItIsShown)
{
  Floorplan plan = storeysWithFlight();
  PlanFlight flight = plan.stairs[0].flights[0];
  flight.bottom = 2.8;
  plan.stairs.push_back({{4, 0}, {6, 0.5}, 2.8, 5.6, {flight}}); // on to a third storey
  const auto storeys = storeysOf(plan);
  const PlanDrawing drawing(plan, sheetOf(storeys[1]), 0);
  std::set<double> treads;
  std::size_t count = 0;
  for (const PlanLine& line : drawing.lines)
    if (line.layer == PlanLayer::Stair && !line.element.isArc() &&
        line.element.start.x() == line.element.end.x()) {
      treads.insert(line.element.start.x());
      ++count;
    }
  EXPECT_EQ(treads.size(), 16u) << "seven of the upper one, nine of the lower one";
  EXPECT_EQ(count, 16u) << "no line lies over another one";
  const std::string sheet = svgOf(plan, sheetOf(storeys[1]));
  EXPECT_TRUE(holds(sheet, ">up<") && holds(sheet, ">down to room 2<"));
}

TEST(StairDrawing, WhereAStairLeadsIsWrittenInItsRoom)
{
  // The ceiling has an edge before the foot of the stair, which texts avoid.
  Floorplan plan = storeysWithFlight();
  plan.rooms[1].details = {detailOf(rectangle(4.05, 0, 4.15, 3), 2.3)};
  const auto storeys = storeysOf(plan);
  const PlanDrawing drawing(plan, sheetOf(storeys[0]), 0);
  std::size_t found = 0;
  for (const PlanText& text : drawing.texts.texts)
    if (text.layer == PlanLayer::Note) {
      EXPECT_EQ(text.text.text, "up to room 4");
      EXPECT_TRUE(plan.rooms[1].contains(drawing.layout.frame.toPlan(text.text.place)));
      ++found;
    }
  EXPECT_EQ(found, 1u);
}

TEST(StairDrawing, TheUndersideOfAStairIsNotDrawn)
{
  Floorplan plan = storeysWithFlight();
  const PlanLoop beside_the_flight = rectangle(4.5, 2, 8, 2.5);
  const PlanLoop above_the_flight = rectangle(5, 0.7, 8, 1.3);
  plan.rooms[1].details = {detailOf(beside_the_flight, 2),
                           detailOf(above_the_flight, 2)};
  const auto storeys = storeysOf(plan);
  std::size_t count = 0;
  for (const PlanLine& line : PlanDrawing(plan, sheetOf(storeys[0]), 0).lines)
    if (line.layer == PlanLayer::Ceiling) {
      EXPECT_LT(beside_the_flight.distance(line.element.start), 0.01);
      ++count;
    }
  EXPECT_EQ(count, 4u);
}

} // namespace

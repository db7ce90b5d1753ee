// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/figures/plan_figures.h"
#include "benchmarks/benchmark_samples.h"
#include "plan_loops.h"

#include <gtest/gtest.h>

#include <cmath>

namespace benchmark_test {
namespace {

using pcl::sedr::Floorplan;
using pcl::sedr::PlanRoom;
using namespace sedr_test;

/** A room of 4 x 3 m with a half circle of 1.5 m radius on its east side. */
std::vector<sim::RoomTruth>
apse()
{
  sim::Room room = sim::test::makeBoxRoom(4.0, 3.0, 2.5);
  room.outline[1].bulge = 1;
  return sim::roomTruths(sim::test::makeScene(room, {}, 1));
}

PlanRoom
foundApse(double radius)
{
  const double half = 1.5;
  const double off = std::sqrt(radius * radius - half * half);
  PlanRoom room = roomOf(rectangle(0, 0, 4, 3), 2.5);
  auto& wall = room.boundary.elements[1];
  wall.centre = {4 + off, half};
  wall.radius = radius;
  return room;
}

TEST(PlanFigures, of_the_truth_itself_are_perfect)
{
  const PlanFigures figures = measurePlan({{foundApse(1.5)}}, apse());
  EXPECT_EQ(figures.corners_true, 4u);
  EXPECT_EQ(figures.corners_found, 4u);
  EXPECT_EQ(figures.rooms_with_other_corners, 0u);
  EXPECT_EQ(figures.arcs_true, 1u);
  EXPECT_EQ(figures.arcs_found, 1u);
  EXPECT_NEAR(figures.corner_distance_max, 0, 1e-9);
  EXPECT_NEAR(figures.radius_error, 0, 1e-9);
  EXPECT_NEAR(figures.perimeter_error, 0, 1e-9);
}

TEST(PlanFigures, tell_a_wrong_radius_and_an_arc_found_straight)
{
  EXPECT_NEAR(measurePlan({{foundApse(1.503)}}, apse()).radius_error, 0.002, 1e-9);
  const PlanFigures straight =
      measurePlan({{roomOf(rectangle(0, 0, 4, 3), 2.5)}}, apse());
  EXPECT_EQ(straight.radius_error, 1);
  EXPECT_EQ(straight.arcs_found, 0u);
  EXPECT_NEAR(straight.perimeter_error, (1.5 * M_PI - 3) / (11 + 1.5 * M_PI), 1e-9);
}

TEST(PlanFigures, a_circle_has_no_corners_in_one_piece_or_two)
{
  sim::Room room = sim::test::makeBoxRoom(4.0, 3.0, 2.5);
  room.columns.push_back(sim::circleLoop({2.0, 1.5}, 0.3));
  const auto truths = sim::roomTruths(sim::test::makeScene(room, {}, 1));
  PlanRoom found = roomOf(rectangle(0, 0, 4, 3), 2.5);
  found.columns.push_back(pcl::sedr::reversed(circle({2, 1.5}, 0.3)));
  const PlanFigures figures = measurePlan({{found}}, truths);
  EXPECT_EQ(figures.corners_true, 4u);
  EXPECT_EQ(figures.corners_found, 4u);
  EXPECT_EQ(figures.arcs_true, 1u);
  EXPECT_NEAR(figures.radius_error, 0, 1e-9);
}

TEST(PlanFigures, a_wall_in_two_pieces_has_a_corner_too_many)
{
  const auto truths = sim::roomTruths(
      sim::test::makeScene(sim::test::makeBoxRoom(4.0, 3.0, 2.5), {}, 1));
  const Floorplan plan{
      {roomOf(polygon({{0, 0}, {2, 0}, {4, 0}, {4.01, 3}, {0, 3}}), 2.5)}};
  const PlanFigures figures = measurePlan(plan, truths);
  EXPECT_EQ(figures.corners_found, 5u);
  EXPECT_EQ(figures.rooms_with_other_corners, 1u);
  EXPECT_NEAR(figures.corner_distance_max, 0.01, 1e-9);
}

TEST(PlanFigures, of_no_rooms_are_not_known)
{
  const PlanFigures figures = measurePlan(Floorplan(), apse());
  EXPECT_FALSE(figures.corners_true.has_value());
  EXPECT_TRUE(std::isnan(figures.radius_error));
}

} // namespace
} // namespace benchmark_test

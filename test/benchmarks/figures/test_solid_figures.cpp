// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/figures/solid_figures.h"
#include "benchmarks/benchmark_samples.h"
#include "plan_loops.h"

#include <pcl/sedr_surface/room_solid.h>

#include <gtest/gtest.h>

#include <cmath>

namespace benchmark_test {
namespace {

using pcl::sedr::Floorplan;
using namespace sedr_test;

/** Compares a true room of 4 x 3 x 2.5 m with the solid of a plan. */
SolidFigures
measured(const pcl::sedr::PlanRoom& room, const sim::Room& real)
{
  TriangleMesh solid;
  std::vector<pcl::sedr::SolidElement> elements;
  pcl::sedr::extrudeRoom(room, {}, solid, elements);
  const SceneTruth truth = truthOfRoom(real);
  return measureSolid(solid, *truth.fine_mesh, {{room}}, truth.rooms);
}

TEST(SolidFigures, of_the_truth_itself_are_perfect)
{
  const SolidFigures figures = measured(roomOf(rectangle(0, 0, 4, 3), 2.5),
                                        sim::test::makeBoxRoom(4.0, 3.0, 2.5));
  EXPECT_EQ(figures.components, 1u);
  EXPECT_TRUE(figures.closed_manifold.value_or(false));
  EXPECT_EQ(figures.self_intersections, 0u);
  EXPECT_EQ(figures.triangles, 12u);
  for (const double off : {figures.truth_to_solid_max, figures.solid_to_truth_max,
                           figures.volume_error, figures.wall_area_error})
    EXPECT_NEAR(off, 0, 1e-6);
}

TEST(SolidFigures, a_wall_off_by_1_cm_shows_in_all_of_them)
{
  const SolidFigures figures = measured(roomOf(rectangle(0, 0, 4.01, 3), 2.5),
                                        sim::test::makeBoxRoom(4.0, 3.0, 2.5));
  EXPECT_NEAR(figures.truth_to_solid_max, 0.01, 1e-6);
  EXPECT_NEAR(figures.truth_to_solid_mean, 0.01 * 7.5 / 59, 1e-5);
  EXPECT_NEAR(figures.solid_to_truth_max, 0.01, 1e-6);
  EXPECT_NEAR(figures.volume_error, 0.01 / 4, 1e-6);
  EXPECT_NEAR(figures.wall_area_error, 0.02 / 14, 1e-6);
}

TEST(SolidFigures, corners_count_for_the_maximum)
{
  // The corner at (4, 3) is cut off by 1 cm, where samples are unlikely.
  const SolidFigures figures =
      measured(roomOf(polygon({{0, 0}, {4, 0}, {4, 2.99}, {3.99, 3}, {0, 3}}), 2.5),
               sim::test::makeBoxRoom(4.0, 3.0, 2.5));
  EXPECT_NEAR(figures.truth_to_solid_max, 0.01 / std::sqrt(2.0), 1e-6);
}

TEST(SolidFigures, the_truth_is_round_where_it_is_round)
{
  sim::Room round;
  round.outline = sim::circleLoop({0.0, 0.0}, 2.0);
  round.ceiling.height = 2.5;
  const auto truth = truthOfRoom(round);
  for (const auto& vertex : truth.fine_mesh->vertices)
    EXPECT_NEAR(vertex.head<2>().norm(), 2, 1e-9);
  // Only the solid's facets deviate, by up to 0.5 mm.
  const SolidFigures figures = measured(roomOf(circle({0, 0}, 2), 2.5), round);
  EXPECT_LE(figures.truth_to_solid_max, 0.00051);
  EXPECT_GT(figures.truth_to_solid_max, 0.0001);
}

TEST(SolidFigures, of_nothing_are_not_measured)
{
  const auto truth = truthOfRoom(sim::test::makeBoxRoom(4.0, 3.0, 2.5));
  EXPECT_FALSE(measureSolid({}, *truth.fine_mesh, {}, truth.rooms).isMeasured());
}

} // namespace
} // namespace benchmark_test

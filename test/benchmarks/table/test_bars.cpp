// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/table/bars.h"
#include "benchmarks/benchmark_samples.h"

#include <gtest/gtest.h>

#include <set>

namespace benchmark_test {
namespace {

std::vector<Bar>
barsMissedBy(const RunRow& row)
{
  std::vector<Bar> bars;
  for (const Miss& miss : missedBars(row))
    bars.push_back(miss.bar);
  return bars;
}

/** Returns the bars that a good run misses after `spoil` has changed it. */
template <typename Spoil>
std::vector<Bar>
missedAfter(Spoil spoil, bool with_mesh = true)
{
  RunRow row = goodRow();
  row.with_mesh = with_mesh;
  spoil(row);
  return barsMissedBy(row);
}

using Bars = std::vector<Bar>;

TEST(Bars, the_limit_of_the_mean_rises_with_the_noise_on_a_straight_line)
{
  EXPECT_DOUBLE_EQ(meanLimit(0.001), 0.002);
  EXPECT_DOUBLE_EQ(meanLimit(0.02), 0.004);
  EXPECT_DOUBLE_EQ(meanLimit(0.0105), 0.003); // half way
  EXPECT_DOUBLE_EQ(meanLimit(0), 0.002);
  EXPECT_DOUBLE_EQ(meanLimit(0.05), 0.004);
}

TEST(Bars, a_good_run_misses_none)
{
  EXPECT_EQ(missedAfter([](RunRow&) {}), Bars{});
  EXPECT_EQ(missedAfter([](RunRow&) {}, false), Bars{});
}

TEST(Bars, each_is_missed_alone)
{
  EXPECT_EQ(missedAfter([](auto& r) { r.failure = "no floor"; }), Bars{Bar::Done});
  EXPECT_EQ(missedAfter([](auto& r) { r.rooms.rooms_true = 5; }), Bars{Bar::Rooms});
  EXPECT_EQ(missedAfter([](auto& r) { r.rooms.rooms_matched = 3; }), Bars{Bar::Rooms});
  EXPECT_EQ(missedAfter([](auto& r) { r.mesh.closed_manifold = false; }),
            Bars{Bar::Closed});
  EXPECT_EQ(missedAfter([](auto& r) { r.mesh.components = 5; }), Bars{Bar::Components});
  EXPECT_EQ(missedAfter([](auto& r) { r.mesh.truth_to_mesh_mean = 0.003; }),
            Bars{Bar::Mean});
  EXPECT_EQ(missedAfter([](auto& r) { r.mesh.truth_within_1cm = 0.949; }),
            Bars{Bar::Within1cm});
  EXPECT_EQ(missedAfter([](auto& r) { r.mesh.truth_within_5cm = 0.989; }),
            Bars{Bar::Within5cm});
  EXPECT_EQ(missedAfter([](auto& r) { r.mesh.mesh_beyond_5cm = 0.0051; }),
            Bars{Bar::ModelBeyond5cm});
  EXPECT_EQ(missedAfter([](auto& r) { r.mesh.detail_within_5cm = 0.969; }),
            Bars{Bar::DetailZone});
}

TEST(Bars, of_solids_are_missed_alone)
{
  EXPECT_EQ(missedAfter([](auto& r) { r.solid = {}; }), Bars{Bar::SolidClosed});
  EXPECT_EQ(missedAfter([](auto& r) { r.solid.closed_manifold = false; }),
            Bars{Bar::SolidClosed});
  EXPECT_EQ(missedAfter([](auto& r) { r.solid.components = 3; }),
            Bars{Bar::SolidClosed});
  EXPECT_EQ(missedAfter([](auto& r) { r.solid.self_intersections = 1; }),
            Bars{Bar::SolidCrossing});
  EXPECT_EQ(missedAfter([](auto& r) { r.solid.truth_to_solid_mean = 0.00031; }),
            Bars{Bar::SolidMean});
  EXPECT_EQ(missedAfter([](auto& r) { r.solid.truth_to_solid_max = 0.0051; }),
            Bars{Bar::SolidMax});
  EXPECT_EQ(missedAfter([](auto& r) { r.solid.volume_error = 0.0051; }),
            Bars{Bar::SolidVolume});
  EXPECT_EQ(missedAfter([](auto& r) { r.solid.wall_area_error = 0.021; }),
            Bars{Bar::WallArea});
  EXPECT_EQ(missedAfter([](auto& r) { r.rooms.area_error = 0.011; }),
            Bars{Bar::PlanArea});
  EXPECT_EQ(missedAfter([](auto& r) { r.plan.radius_error = 0.011; }),
            Bars{Bar::Radius});
  EXPECT_EQ(missedAfter([](auto& r) { r.plan.rooms_with_other_corners = 1; }),
            Bars{Bar::Corners});
}

TEST(Bars, of_triangles_is_for_straight_walls)
{
  EXPECT_EQ(missedAfter([](auto& r) { r.solid.triangles = 5001; }), Bars{});
  EXPECT_EQ(missedAfter([](auto& r) {
              r.solid.triangles = 5001;
              r.plan.arcs_true = 0;
            }),
            Bars{Bar::SolidTriangles});
}

TEST(Bars, the_limits_of_solids_rise_with_the_noise_in_steps)
{
  EXPECT_DOUBLE_EQ(solidLimits(0.001).mean, 0.0001);
  EXPECT_DOUBLE_EQ(solidLimits(0.001).max, 0.001);
  EXPECT_DOUBLE_EQ(solidLimits(0.005).mean, 0.0003);
  EXPECT_DOUBLE_EQ(solidLimits(0.01).max, 0.005);
  EXPECT_DOUBLE_EQ(solidLimits(0.02).mean, 0.001);
  EXPECT_DOUBLE_EQ(solidLimits(0.02).max, 0.01);
}

TEST(Bars, what_lies_on_its_bar_reaches_it)
{
  RunRow row = goodRow("sample", 0.001);
  row.solid = {4, true, 0, 5000, 0.0001, 0.001, 0, 0, 0.005, 0.02};
  row.mesh.truth_to_mesh_mean = 0.002;
  row.mesh.truth_within_1cm = 0.95;
  row.mesh.truth_within_5cm = 0.99;
  row.mesh.mesh_beyond_5cm = 0.005;
  row.mesh.detail_within_5cm = 0.97;
  EXPECT_EQ(barsMissedBy(row), Bars{});
}

TEST(Bars, a_scene_without_details_has_none_for_them)
{
  EXPECT_EQ(missedAfter([](auto& r) { r.mesh.detail_within_5cm = not_known; }), Bars{});
}

TEST(Bars, without_a_mesh_the_points_have_their_own)
{
  const auto spoil = [](auto& r) { r.mesh = ModelFigures(); };
  EXPECT_EQ(missedAfter(spoil, false), Bars{});
  EXPECT_EQ(missedAfter([](auto& r) { r.structure.points_beyond_5cm = 0.006; }, false),
            Bars{Bar::PointsBeyond5cm});
  EXPECT_EQ(missedAfter([](auto& r) { r.structure.truth_covered = 0.98; }, false),
            Bars{Bar::Covered});
}

TEST(Bars, what_was_not_measured_misses_them)
{
  EXPECT_EQ(missedAfter([](auto& r) { r.mesh = ModelFigures(); }),
            (Bars{Bar::Closed, Bar::Components, Bar::Mean, Bar::Within1cm,
                  Bar::Within5cm, Bar::ModelBeyond5cm}));
}

TEST(Bars, a_miss_tells_by_how_much)
{
  RunRow row = goodRow("sample", 0.02);
  row.rooms.rooms_found = 3;
  row.mesh.components = 3;
  row.mesh.truth_to_mesh_mean = 0.0051;
  row.mesh.truth_within_5cm = 0.9812;
  const auto misses = missedBars(row);
  ASSERT_EQ(misses.size(), 3u);
  EXPECT_EQ(misses[0].text, "3 rooms of 4");
  EXPECT_EQ(misses[1].text, "mean 0.510 cm > 0.400 cm");
  EXPECT_EQ(misses[2].text, "within 5 cm 98.12 % < 99 %");
}

} // namespace
} // namespace benchmark_test

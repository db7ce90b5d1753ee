// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/runs/run.h"
#include "benchmarks/benchmark_samples.h"
#include "simulator/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace benchmark_test {
namespace {

/** An empty room of 4 x 3 x 2.5 m, scanned from its middle. */
sim::Scene
emptyRoom()
{
  return sim::test::makeScene(sim::test::makeBoxRoom(4.0, 3.0, 2.5), {2.0, 1.5, 1.2},
                              150'000);
}

RunSettings
quick()
{
  RunSettings settings;
  settings.with_mesh = false;
  return settings;
}

TEST(Run, of_an_empty_room_finds_it)
{
  const RunRow row = runScene(emptyRoom(), quick());
  EXPECT_EQ(row.failure, "");
  EXPECT_EQ(row.scene, "sample");
  EXPECT_GT(row.points, 100'000u);
  EXPECT_EQ(row.rooms.rooms_found, 1u);
  EXPECT_EQ(row.rooms.rooms_matched, 1u);
  EXPECT_LT(row.rooms.area_error, 0.005);
  EXPECT_LT(row.rooms.volume_error, 0.005);
  EXPECT_LT(row.structure.points_to_truth_mean, 0.002);
  EXPECT_GT(row.structure.truth_covered, 0.99);
  for (std::size_t k = 0; k < 3; ++k) { // ceiling, floor, wall
    EXPECT_GT(row.labels[k].recall, 0.97) << k;
    EXPECT_GT(row.labels[k].precision, 0.97) << k;
  }
  EXPECT_TRUE(row.solid.closed_manifold.value_or(false));
  EXPECT_EQ(row.solid.self_intersections, 0u);
  EXPECT_LT(row.solid.truth_to_solid_max, 0.002);
  EXPECT_LT(row.solid.wall_area_error, 0.002);
  EXPECT_EQ(row.plan.corners_found, 4u);
  EXPECT_FALSE(row.mesh.isMeasured());
  EXPECT_FALSE(row.stage_seconds.empty());
}

TEST(Run, gives_the_same_figures_again)
{
  RunRow a = runScene(emptyRoom(), quick());
  RunRow b = runScene(emptyRoom(), quick());
  for (RunRow* row : {&a, &b}) {
    row->seconds = 0;
    row->stage_seconds.clear();
  }
  EXPECT_EQ(toCsv(a), toCsv(b));
}

TEST(Run, that_finds_nothing_is_a_row_with_the_reason)
{
  RunSettings settings = quick();
  settings.rays = 300; // too few to show any plane
  const RunRow row = runScene(emptyRoom(), settings);
  EXPECT_NE(row.failure, "");
  EXPECT_EQ(row.rooms.rooms_true, 1u);
  EXPECT_EQ(row.rooms.rooms_found, 0u);
  EXPECT_FALSE(row.structure.isMeasured());
}

TEST(Run, of_a_scene_that_cannot_be_built_is_a_row_with_the_reason)
{
  sim::Scene scene = emptyRoom();
  scene.rooms[0].openings.push_back({17, 0.1, 1.0, 0.0, 2.0}); // wall 17 does not exist
  EXPECT_NE(runScene(scene, quick()).failure, "");
}

TEST(Run, keeps_its_files_when_asked_to)
{
  const sim::test::TemporaryFolder folder;
  RunSettings settings = quick();
  settings.keep = folder.path() / "kept";
  settings.noise = 0.005;
  settings.seed = 3;
  ASSERT_EQ(runScene(emptyRoom(), settings).failure, "");
  const auto kept = settings.keep / "sample_n0.005_s3";
  for (const char* name : {"scan.pcd", "truth.ply", "truth.json", "structure.pcd",
                           "floorplan.json", "solid.ply"})
    EXPECT_TRUE(std::filesystem::exists(kept / name)) << name;
  EXPECT_FALSE(std::filesystem::exists(kept / "mesh.ply")); // none was made
}

} // namespace
} // namespace benchmark_test

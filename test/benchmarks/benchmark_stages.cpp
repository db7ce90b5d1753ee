// SPDX-License-Identifier: BSD-3-Clause
// Seconds of each stage by number of points and of cells: adjacent rooms of 5 m x 4 m.
#include "room_points.h"

#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <benchmark/benchmark.h>

#include <map>
#include <string>

namespace {

using namespace sedr_test;

constexpr int max_in_a_row = 8;

/** @brief Makes rooms with a soffit along one wall and noise of 5 mm. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
storey(int rooms, double spacing)
{
  RoomPoints points(spacing, 0.005);
  for (int r = 0; r < rooms; ++r) {
    const double x = 5.12 * (r % max_in_a_row);
    const double y = 4.12 * (r / max_in_a_row);
    pcl::sedr::PlanRoom room = roomOf(rectangle(x, y, x + 5, y + 4), 2.6);
    room.details = {detailOf(rectangle(x, y, x + 5, y + 0.8), 2.3)};
    points.room(room);
  }
  return points.cloud();
}

/** @brief Reports the seconds of each stage as counters. */
void
Stages(benchmark::State& state)
{
  const auto rooms = static_cast<int>(state.range(0));
  const auto millimetres = static_cast<double>(state.range(1));
  const auto cloud = storey(rooms, millimetres / 1000);
  std::map<std::string, double> seconds;
  std::size_t thinned = 0;
  for (auto _ : state) {
    seconds.clear();
    pcl::IndoorStructureReconstruction<pcl::PointXYZ> chain;
    chain.setInputCloud(cloud);
    pcl::PolygonMesh mesh;
    chain.reconstruct(mesh);
    for (const auto& report : chain.getModel().reports)
      seconds[report.name] += report.seconds;
    thinned = chain.getModel().reports.front().points_out;
    if (mesh.polygons.empty())
      state.SkipWithError(chain.getErrorMessage().c_str());
  }
  for (const auto& [name, sum] : seconds)
    state.counters[name] = sum;
  state.counters["points"] = static_cast<double>(cloud->size());
  state.counters["thinned"] = static_cast<double>(thinned);
}

// First more points in the same cells, then more cells at the same density.
BENCHMARK(Stages)
    ->ArgNames({"rooms", "mm"})
    ->ArgsProduct({{4}, {40, 20, 10}})
    ->ArgsProduct({{1, 4, 16, 64}, {25}})
    ->Iterations(1)
    ->Repetitions(3)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();

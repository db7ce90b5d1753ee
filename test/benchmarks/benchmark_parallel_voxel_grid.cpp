// SPDX-License-Identifier: BSD-3-Clause
// pcl::ParallelVoxelGrid, pcl::VoxelGrid and pcl::ApproximateVoxelGrid at 5 cm.
#include <pcl/sedr_filters/parallel_voxel_grid.h>

#include <pcl/filters/approximate_voxel_grid.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <string>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

enum class Order { Scan, Random };

constexpr float leaf = 0.05f;
constexpr std::size_t points_a_room = 1000000;

/** @brief Returns point @p i of a terrestrial scan of adjacent rooms of 6 x 5 x 2.8 m.
 * A turning mirror scans column by column, with noise of 2 mm along the ray. */
pcl::PointXYZ
pointOf(std::size_t i, std::mt19937& random)
{
  constexpr std::size_t columns = 1250;
  constexpr std::size_t rows = points_a_room / columns;
  const std::size_t room = i / points_a_room;
  const std::size_t in_room = i % points_a_room;
  const double azimuth = 2 * M_PI * static_cast<double>(in_room / rows) / columns;
  const double height =
      -1.1 + (1.1 + M_PI / 2) * (static_cast<double>(in_room % rows) + 0.5) / rows;
  const double x = std::cos(azimuth) * std::cos(height);
  const double y = std::sin(azimuth) * std::cos(height);
  const double z = std::sin(height);
  const double range =
      std::min({(x > 0 ? 3.4 : 2.6) / std::abs(x), (y > 0 ? 2.2 : 2.8) / std::abs(y),
                (z > 0 ? 1.3 : 1.5) / std::abs(z)}) +
      0.002 * std::normal_distribution<double>()(random);
  constexpr std::size_t rooms_a_row = 8;
  return {static_cast<float>(x * range + 6.2 * static_cast<double>(room % rooms_a_row)),
          static_cast<float>(y * range + 5.2 * static_cast<double>(room / rooms_a_row)),
          static_cast<float>(z * range)};
}

/** @brief Returns the cloud of a benchmark and caches it for the next one. */
const Cloud::Ptr&
cloudOf(std::size_t points, Order order)
{
  static Cloud::Ptr cloud;
  static Order order_of_cloud = Order::Scan;
  if (cloud && cloud->size() == points && order_of_cloud == order)
    return cloud;
  cloud.reset(new Cloud);
  cloud->resize(points);
  std::mt19937 random(1);
  for (std::size_t i = 0; i < points; ++i)
    (*cloud)[i] = pointOf(i, random);
  if (order == Order::Random)
    std::shuffle(cloud->begin(), cloud->end(), random);
  order_of_cloud = order;
  return cloud;
}

/** @brief Returns a line of /proc/self/status in MiB; 0 if it is missing. */
double
memoryLine(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == name) {
      double kibibytes = 0;
      status >> kibibytes;
      return kibibytes / 1024;
    }
  return 0;
}

/** @brief Thins a cloud; reports the time, the peak memory beside the input and the
 * number of remaining points. */
template <typename FilterT>
void
thin(benchmark::State& state, FilterT& filter)
{
  const auto order = static_cast<Order>(state.range(1));
  const auto points = static_cast<std::size_t>(state.range(0)) * 1000000;
  const Cloud::Ptr cloud = cloudOf(points, order);
  filter.setLeafSize(leaf, leaf, leaf);
  double memory = 0;
  std::size_t left = 0;
  for (auto _ : state) {
    std::ofstream("/proc/self/clear_refs") << 5; // resets the peak
    const double before = memoryLine("VmRSS:");
    filter.setInputCloud(cloud);
    Cloud output;
    filter.filter(output);
    left = output.size();
    memory = std::max(memory, memoryLine("VmHWM:") - before);
  }
  state.SetLabel(order == Order::Scan ? "as scanned" : "in random order");
  state.counters["MiB"] = memory;
  state.counters["voxels"] = static_cast<double>(left);
  state.counters["points/s"] = benchmark::Counter(
      static_cast<double>(points), benchmark::Counter::kIsIterationInvariantRate);
}

void
VoxelGrid(benchmark::State& state)
{
  pcl::VoxelGrid<pcl::PointXYZ> filter;
  thin(state, filter);
}

void
ApproximateVoxelGrid(benchmark::State& state)
{
  pcl::ApproximateVoxelGrid<pcl::PointXYZ> filter;
  thin(state, filter);
}

void
ParallelVoxelGrid(benchmark::State& state)
{
  pcl::ParallelVoxelGrid<pcl::PointXYZ> filter;
  filter.setNumberOfThreads(static_cast<unsigned>(state.range(2)));
  thin(state, filter);
}

void
clouds(benchmark::internal::Benchmark* b)
{
  b->ArgNames({"Mpoints", "random"})->ArgsProduct({{1, 3, 10, 30, 50}, {0, 1}});
}

void
cloudsAndThreads(benchmark::internal::Benchmark* b)
{
  b->ArgNames({"Mpoints", "random", "threads"})
      ->ArgsProduct({{1, 3, 10, 30, 50}, {0, 1}, {1, 2}});
}

void
measured(benchmark::internal::Benchmark* b)
{
  b->Iterations(1)->Repetitions(5)->MeasureProcessCPUTime()->UseRealTime()->Unit(
      benchmark::kMillisecond);
}

BENCHMARK(VoxelGrid)->Apply(clouds)->Apply(measured);
BENCHMARK(ApproximateVoxelGrid)->Apply(clouds)->Apply(measured);
BENCHMARK(ParallelVoxelGrid)->Apply(cloudsAndThreads)->Apply(measured);

} // namespace

BENCHMARK_MAIN();

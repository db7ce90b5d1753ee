// SPDX-License-Identifier: BSD-3-Clause
// Measures how fast scans of each format are read, and thinned while reading:
//
//     benchmark_scan_formats FOLDER MILLIONS [options of google-benchmark]
//
// The files are scan.pcd, scan.e57 (scaled integers of 18 bits, 0.1 mm), scan.las and
// scan.xyz in FOLDER, read from the page cache. Missing ones are written: a room of
// MILLIONS million points in the order of a scanner.
#include "scan_file.h"
#include "tools/sample_files.h"
#include "tools/scans/e57_writer.h"
#include "tools/scans/las_writer.h"

#include <pcl/sedr_filters/parallel_voxel_grid.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace {

using pcl::sedr::RowSource;
using pcl::sedr::tools::ScanFile;

constexpr double unit = 1e-4; // metres

/** The points where the rays of a sweep hit a box room of 8 x 6 x 2.8 m. */
std::vector<std::array<std::int32_t, 3>>
roomPoints(std::size_t n)
{
  const std::array<double, 3> low{-3, -2, -1.5}, high{5, 4, 1.3};
  const auto across = static_cast<std::size_t>(std::sqrt(static_cast<double>(n) / 2));
  std::vector<std::array<std::int32_t, 3>> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double azimuth = 2 * M_PI * static_cast<double>(i / across) * across / n;
    const double elevation =
        M_PI * (static_cast<double>(i % across) / static_cast<double>(across) - 0.5);
    const std::array<double, 3> ray{std::cos(azimuth) * std::cos(elevation),
                                    std::sin(azimuth) * std::cos(elevation),
                                    std::sin(elevation)};
    double range = 100;
    for (std::size_t k = 0; k < 3; ++k)
      if (std::abs(ray[k]) > 1e-9)
        range = std::min(range, (ray[k] > 0 ? high[k] : low[k]) / ray[k]);
    points.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      points.back()[k] = static_cast<std::int32_t>(std::lround(range * ray[k] / unit));
  }
  return points;
}

void
writeScans(const std::filesystem::path& folder, std::size_t n)
{
  const auto points = roomPoints(n);
  std::vector<std::vector<float>> floats;
  std::vector<std::vector<std::int64_t>> whole(3);
  std::string text;
  for (const auto& p : points) {
    floats.push_back({});
    for (std::size_t k = 0; k < 3; ++k) {
      floats.back().push_back(static_cast<float>(p[k] * unit));
      whole[k].push_back(p[k]);
    }
    char line[80];
    std::snprintf(line, sizeof line, "%.4f %.4f %.4f\n", p[0] * unit, p[1] * unit,
                  p[2] * unit);
    text += line;
  }
  programs::writeFile(folder / "scan.pcd", programs::pcdBytes(floats));
  programs::writeFile(folder / "scan.xyz", text);
  programs::LasSample las;
  las.scale = {unit, unit, unit};
  las.points = points;
  programs::writeFile(folder / "scan.las", las.bytes());
  programs::E57Writer e57;
  e57.packet_bytes = 60000;
  std::vector<programs::E57TestField> fields;
  for (std::size_t k = 0; k < 3; ++k)
    fields.push_back(programs::E57TestField::ofIntegers(
        std::string("cartesian") + "XYZ"[k], whole[k], -131072, 131071,
        "scale=\"0.0001\""));
  e57.addScan("room", fields,
              programs::E57Writer::pose(std::sqrt(0.5), 0, 0, std::sqrt(0.5), 1, 2, 3));
  programs::writeFile(folder / "scan.e57", e57.file());
}

void
readAll(benchmark::State& state, const std::string& path)
{
  const ScanFile scan(path);
  for (auto _ : state) {
    std::size_t points = 0;
    scan.forEachPiece([&](const RowSource::Piece& piece) {
      points += piece.size;
      benchmark::DoNotOptimize(piece.rows);
      return true;
    });
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(scan.size()) *
                          static_cast<std::int64_t>(state.iterations()));
}

void
thin(benchmark::State& state, const std::string& path)
{
  const ScanFile scan(path);
  for (auto _ : state) {
    pcl::ParallelVoxelGrid<pcl::PointXYZ> grid;
    pcl::PointCloud<pcl::PointXYZ> thinned;
    grid.filter(scan, thinned);
    benchmark::DoNotOptimize(thinned.data());
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(scan.size()) *
                          static_cast<std::int64_t>(state.iterations()));
}

} // namespace

int
main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  if (argc != 3) {
    std::fprintf(stderr, "usage: benchmark_scan_formats FOLDER MILLIONS\n");
    return 1;
  }
  const std::filesystem::path folder = argv[1];
  const auto n = static_cast<std::size_t>(std::atof(argv[2]) * 1e6);
  if (!std::filesystem::exists(folder / "scan.e57"))
    writeScans(folder, n);
  for (const char* name : {"scan.pcd", "scan.e57", "scan.las", "scan.xyz"}) {
    const std::string path = (folder / name).string();
    for (const auto& [what, run] :
         {std::make_pair("read ", &readAll), {"thin ", &thin}})
      benchmark::RegisterBenchmark(
          (what + std::string(name)).c_str(),
          [run = run, path](benchmark::State& state) { run(state, path); })
          ->Unit(benchmark::kMillisecond)
          ->UseRealTime();
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

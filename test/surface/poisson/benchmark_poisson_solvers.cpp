// SPDX-License-Identifier: BSD-3-Clause
// Compares StructuralPoisson with pcl::Poisson on structures with a truth, and prints
// the table of doc/structural_poisson.md.
//
//     benchmark_poisson_solvers RUNS THREADS FOLDER...
//     benchmark_poisson_solvers STRUCTURE.pcd MESH.ply  (only pcl::Poisson's mesh)
//
// Each FOLDER holds out/structure.pcd and truth.ply, as proving_ground.py --keep leaves
// them. Seconds are the median of RUNS runs in which the solvers alternate: processor
// time with one thread, wall-clock time with more.
#include <pcl/io/pcd_io.h>
#include <pcl/sedr_surface/mesh_distance.h>
#include <pcl/sedr_surface/mesh_io.h>
#include <pcl/sedr_surface/mesh_topology.h>
#include <pcl/sedr_surface/structural_poisson.h>
#include <pcl/surface/poisson.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

using namespace pcl::sedr;

namespace {

using Poisson = pcl::StructuralPoisson<pcl::PointStructure>;
using Cloud = pcl::PointCloud<pcl::PointStructure>;

struct Figures {
  std::vector<double> seconds;
  double mean = 0;
  double p99 = 0;
  double max = 0;
  double back_max = 0; ///< from the mesh to the truth
  std::size_t triangles = 0;
  bool closed = false;
};

double
median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double
secondsOf(unsigned threads, const std::function<void()>& work)
{
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t clock = std::clock();
  work();
  const double processor = static_cast<double>(std::clock() - clock) / CLOCKS_PER_SEC;
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  return threads == 1 ? processor : passed.count();
}

void
runSedr(const Cloud::ConstPtr& cloud,
        unsigned threads,
        Figures& figures,
        TriangleMesh& mesh)
{
  Poisson poisson;
  poisson.setInputCloud(cloud);
  poisson.setNumberOfThreads(threads);
  figures.seconds.push_back(secondsOf(threads, [&] { poisson.makeMesh(); }));
  figures.closed = poisson.isClosed();
  mesh = poisson.getMesh();
}

/** @brief Runs pcl::Poisson room by room, with cells of the size of StructuralPoisson:
 * depth and scale of the octree are chosen accordingly. */
void
runPcl(const Cloud::ConstPtr& cloud,
       unsigned threads,
       Figures& figures,
       TriangleMesh& mesh)
{
  std::map<std::uint32_t, pcl::PointCloud<pcl::PointNormal>::Ptr> rooms;
  for (const auto& p : *cloud) {
    auto& room = rooms[p.room];
    if (!room)
      room = std::make_shared<pcl::PointCloud<pcl::PointNormal>>();
    pcl::PointNormal point;
    point.getVector3fMap() = p.getVector3fMap();
    point.getNormalVector3fMap() = p.getNormalVector3fMap();
    room->push_back(point);
  }
  mesh = TriangleMesh();
  figures.closed = true;
  figures.seconds.push_back(secondsOf(threads, [&] {
    for (const auto& [number, room] : rooms) {
      constexpr double cell = 0.04; // metres: 0.8 times the spacing of the points
      Eigen::AlignedBox3f box;
      for (const auto& p : *room)
        box.extend(p.getVector3fMap());
      const double extent = static_cast<double>(box.sizes().maxCoeff());
      const int depth =
          std::clamp(static_cast<int>(std::ceil(std::log2(1.1 * extent / cell))), 3, 9);
      pcl::Poisson<pcl::PointNormal> poisson;
      poisson.setDepth(depth);
      poisson.setPointWeight(10);
      poisson.setScale(
          static_cast<float>(std::max(1.1, cell * std::ldexp(1., depth) / extent)));
      poisson.setSamplesPerNode(1);
      poisson.setInputCloud(room);
      pcl::PolygonMesh polygons;
      poisson.reconstruct(polygons);
      TriangleMesh surface;
      figures.closed = fromPolygonMesh(polygons, surface).empty() &&
                       checkTopology(surface).isClosedManifold() && figures.closed;
      mesh.append(surface);
    }
  }));
}

void
compare(const TriangleMesh& mesh, const TriangleMesh& truth, Figures& figures)
{
  constexpr double apart = 0.02; // metres
  auto off = MeshDistance(mesh).distances(sampleMesh(truth, apart, 1).points);
  const auto statistics = summarizeDistances(off);
  const auto rank = off.begin() + static_cast<std::ptrdiff_t>(0.99 * off.size());
  std::nth_element(off.begin(), rank, off.end());
  figures.mean = statistics.mean;
  figures.p99 = *rank;
  figures.max = statistics.max;
  figures.back_max = summarizeDistances(MeshDistance(truth).distances(
                                            sampleMesh(mesh, apart, 1).points))
                         .max;
  figures.triangles = mesh.triangles.size();
}

bool
compareOn(const std::string& folder,
          int runs,
          unsigned threads,
          std::vector<double>& gains)
{
  const Cloud::Ptr cloud(new Cloud);
  TriangleMesh truth;
  if (pcl::io::loadPCDFile(folder + "/out/structure.pcd", *cloud) < 0)
    return false;
  const std::string problem = loadMesh(folder + "/truth.ply", truth);
  if (!problem.empty()) {
    std::fprintf(stderr, "%s\n", problem.c_str());
    return false;
  }
  Figures figures[2]; // pcl, sedr
  TriangleMesh meshes[2];
  for (int i = 0; i < runs; ++i) {
    runPcl(cloud, threads, figures[0], meshes[0]);
    runSedr(cloud, threads, figures[1], meshes[1]);
  }
  for (int i = 0; i < 2; ++i)
    compare(meshes[i], truth, figures[i]);
  const Figures& p = figures[0];
  const Figures& s = figures[1];
  gains.push_back(median(p.seconds) / median(s.seconds));
  const std::string name = folder.substr(folder.find_last_of('/') + 1);
  std::printf("| %s | %.2f / %.2f | %.1f | %.3f / %.3f | %.2f / %.2f | "
              "%.2f / %.2f | %.2f / %.2f | %zu / %zu | %s / %s |\n",
              name.c_str(), median(p.seconds), median(s.seconds), gains.back(),
              100 * p.mean, 100 * s.mean, 100 * p.p99, 100 * s.p99, 100 * p.max,
              100 * s.max, 100 * p.back_max, 100 * s.back_max, p.triangles / 1000,
              s.triangles / 1000, p.closed ? "yes" : "no", s.closed ? "yes" : "no");
  std::fflush(stdout);
  return true;
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc == 3) {
    const Cloud::Ptr cloud(new Cloud);
    Figures figures;
    TriangleMesh mesh;
    if (pcl::io::loadPCDFile(argv[1], *cloud) < 0)
      return 1;
    runPcl(cloud, 1, figures, mesh);
    const std::string problem = savePly(argv[2], mesh);
    if (problem.empty())
      return 0;
    std::fprintf(stderr, "%s\n", problem.c_str());
    return 1;
  }
  const int runs = argc > 3 ? std::atoi(argv[1]) : 0;
  if (runs < 1) {
    std::fprintf(stderr, "usage: benchmark_poisson_solvers RUNS THREADS FOLDER...\n");
    return 1;
  }
  std::printf("| run | s | times | mean, cm | p99, cm | max, cm | mesh to truth "
              "max, cm | thousand triangles | closed |\n"
              "|---|---|---|---|---|---|---|---|---|\n");
  std::vector<double> gains;
  for (int i = 3; i < argc; ++i)
    if (!compareOn(argv[i], runs, static_cast<unsigned>(std::atoi(argv[2])), gains))
      return 1;
  std::printf("\nMedian: %.1f times as fast.\n", median(gains));
}

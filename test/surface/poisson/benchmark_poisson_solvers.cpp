// SPDX-License-Identifier: BSD-3-Clause
// Compares the two solvers of StructuralPoisson on structures with a truth: prints the
// table of doc/structural_poisson.md.
//
//     benchmark_poisson_solvers RUNS THREADS FOLDER...
//
// Each FOLDER holds structure.pcd and truth.ply, as pcl_sedr_benchmark --keep leaves
// them. Seconds are the median of RUNS runs, in which the solvers take turns: of the
// processor with one thread, by the clock with more.
#include <pcl/io/pcd_io.h>
#include <pcl/sedr_surface/mesh_distance.h>
#include <pcl/sedr_surface/mesh_io.h>
#include <pcl/sedr_surface/structural_poisson.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
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

void
run(const Cloud::ConstPtr& cloud,
    Poisson::Solver solver,
    unsigned threads,
    Figures& figures,
    TriangleMesh& mesh)
{
  Poisson poisson;
  poisson.setInputCloud(cloud);
  poisson.setSolver(solver);
  poisson.setNumberOfThreads(threads);
  pcl::PolygonMesh unused;
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t clock = std::clock();
  poisson.reconstruct(unused);
  const double processor = static_cast<double>(std::clock() - clock) / CLOCKS_PER_SEC;
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  figures.seconds.push_back(threads == 1 ? processor : passed.count());
  figures.closed = poisson.isClosed();
  mesh = poisson.getMesh();
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
  if (pcl::io::loadPCDFile(folder + "/structure.pcd", *cloud) < 0)
    return false;
  const std::string problem = loadMesh(folder + "/truth.ply", truth);
  if (!problem.empty()) {
    std::fprintf(stderr, "%s\n", problem.c_str());
    return false;
  }
  Figures figures[2]; // pcl, sedr
  TriangleMesh meshes[2];
  for (int i = 0; i < runs; ++i) {
    run(cloud, Poisson::Solver::Pcl, threads, figures[0], meshes[0]);
    run(cloud, Poisson::Solver::Sedr, threads, figures[1], meshes[1]);
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

// SPDX-License-Identifier: BSD-3-Clause
// Prints the table of doc/structural_poisson.md: rooms of exact points, reconstructed
// and compared with their exact surface.
#include "surface/chain/lattice_room.h"

#include "sedr_surface/src/poisson/room_poisson.h"
#include <pcl/sedr_surface/mesh_distance.h>

#include <cstdio>
#include <ctime>

using namespace pcl::sedr;
using namespace sedr_test;

namespace {

void
measure(const char* name,
        const LatticeRoom& room,
        double spacing,
        double ratio,
        float weight)
{
  RoomPoissonParameters parameters;
  parameters.cell_ratio = ratio;
  parameters.point_weight = weight;
  TriangleMesh mesh;
  std::vector<std::uint32_t> nearest;
  RoomPoissonReport report;
  const auto points = room.points(spacing);
  const std::clock_t start = std::clock();
  reconstructRoom(points, parameters, mesh, nearest, report);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const auto s = summarizeDistances(
      MeshDistance(mesh).distances(sampleMesh(room.truth(), 0.02, 1).points));
  std::printf("| %s | %.1f | %.2f | %.0f | %.1f | %.1f | %zu | %.3f | %.2f | %.1f "
              "| %s |\n",
              name, 100 * spacing, ratio, static_cast<double>(weight),
              100 * report.cell, seconds, mesh.triangles.size(), 100 * s.mean,
              100 * s.max, 100 * s.within_1cm, report.closed ? "yes" : "no");
  std::fflush(stdout);
}

} // namespace

int
main()
{
  const Eigen::Vector3d shift(0.13, 0.27, 0.31);
  std::printf("| room | points, cm | cell ratio | weight | cell, cm | s | "
              "triangles | mean, "
              "cm | max, cm | %% <= 1 cm | closed "
              "|\n|---|---|---|---|---|---|---|---|---|---|---|\n");
  measure("box", boxRoom().placed(17, shift), 0.05, 0.8, 10);
  measure("L", lRoom().placed(17, shift), 0.05, 0.8, 10);
  measure("column", columnRoom().placed(17, shift), 0.05, 0.8, 10);
  const LatticeRoom room = soffitRoom().placed(17, shift);
  for (const float weight : {4.f, 10.f, 30.f})
    measure("soffit", room, 0.05, 0.8, weight);
  for (const double ratio : {0.6, 1., 1.5})
    measure("soffit", room, 0.05, ratio, 10);
  measure("soffit", room, 0.1, 0.8, 10);
  measure("soffit", room, 1. / 30, 0.8, 10);
  measure("soffit", room, 0.025, 0.8, 10);
}

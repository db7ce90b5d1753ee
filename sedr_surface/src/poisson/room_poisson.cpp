// SPDX-License-Identifier: BSD-3-Clause
#include "../mesh/mesh_repair.h"
#include "../solver/point_spacing.h"
#include "room_support.h"
#include "screened_poisson.h"
#include <pcl/sedr_surface/impl/room_samples.h>

#include "room_poisson.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {
namespace {

// Returns the points near the origin, where floats have precision to spare.
std::vector<OrientedPoint>
centred(const std::vector<OrientedPoint>& points, const Eigen::Vector3d& centre)
{
  std::vector<OrientedPoint> local = points;
  for (OrientedPoint& p : local)
    p.position = (p.position.cast<double>() - centre).cast<float>();
  return local;
}

double
extentOf(const std::vector<OrientedPoint>& points)
{
  Eigen::AlignedBox3f box;
  for (const OrientedPoint& p : points)
    box.extend(p.position);
  return box.sizes().maxCoeff();
}

// Rounds to float, so that what is checked is what is written.
void
roundToFloat(TriangleMesh& mesh)
{
  for (Eigen::Vector3d& v : mesh.vertices)
    for (int k = 0; k < 3; ++k) {
      volatile float rounded =
          static_cast<float>(v[k]); // volatile, or g++ 12 omits the rounding at -O2
      v[k] = static_cast<double>(rounded);
    }
}

bool
hasEqualPositions(const TriangleMesh& mesh)
{
  TriangleMesh copy = mesh;
  return weldVertices(copy) > 0;
}

void
move(TriangleMesh& mesh, const Eigen::Vector3d& centre)
{
  for (Eigen::Vector3d& v : mesh.vertices)
    v += centre;
  roundToFloat(mesh);
}

// Reports why the mesh is not one closed surface.
void
checkRoom(const TriangleMesh& mesh, RoomPoissonReport& report)
{
  report.topology = checkTopology(mesh);
  report.problem = report.topology.problem();
  if (report.topology.components.size() > 1)
    report.problem += (report.problem.empty() ? "" : ", ") +
                      std::to_string(report.topology.components.size()) + " components";
  else if (report.problem.empty() && hasEqualPositions(mesh))
    report.problem = "vertices at equal positions";
  report.closed = report.problem.empty();
}

// Solves for the surface of points near the origin.
bool
solveOnBand(const std::vector<OrientedPoint>& local,
            const Eigen::Vector3d& centre,
            double extent,
            const RoomPoissonParameters& parameters,
            TriangleMesh& mesh,
            RoomPoissonReport& report)
{
  constexpr double margin = 1.1; // of the octree's cube, to which the depth refers
  const double wanted = report.spacing * parameters.cell_ratio;
  const auto depth =
      static_cast<int>(std::ceil(std::log2(margin * extent / wanted) - 1e-9));
  report.depth = std::clamp(depth, 3, parameters.depth);
  ScreenedPoissonParameters solver;
  solver.cell = std::max(wanted, margin * extent / std::ldexp(1., report.depth));
  solver.spacing = report.spacing;
  solver.point_weight = parameters.point_weight;
  solver.threads = parameters.threads;
  const std::string failure = screenedPoisson(local, solver, mesh, report.screened);
  report.cell = report.screened.cell;
  if (!failure.empty()) {
    report.problem = failure;
    return false;
  }
  if (report.cell > 1.001 * solver.cell)
    report.warning = "its cells are " + shortNumber(report.cell) + " m instead of " +
                     shortNumber(solver.cell) + " m, for so large a surface";
  move(mesh, centre);
  const RemovedComponents removed = keepLargestComponent(mesh);
  report.removed_components = removed.components;
  report.removed_triangles = removed.triangles;
  mesh.removeUnusedVertices();
  checkRoom(mesh, report);
  if (!report.closed) { // far from the origin, floats may coincide
    report.parted_vertices = partEqualPositions(mesh);
    checkRoom(mesh, report);
  }
  return !mesh.empty();
}

bool
solve(const std::vector<OrientedPoint>& points,
      const RoomPoissonParameters& parameters,
      TriangleMesh& mesh,
      RoomPoissonReport& report)
{
  const Eigen::Vector3d centre = centroidOf(points);
  const std::vector<OrientedPoint> local = centred(points, centre);
  const double extent = extentOf(local);
  report.spacing = measureSpacing(local);
  if (!(report.spacing > 0) || !(extent > 4 * report.spacing)) {
    report.problem = "the " + std::to_string(points.size()) + " points extend over " +
                     shortNumber(extent) + " m only";
    return false;
  }
  return solveOnBand(local, centre, extent, parameters, mesh, report);
}

} // namespace

bool
reconstructRoom(const std::vector<OrientedPoint>& points,
                const RoomPoissonParameters& parameters,
                TriangleMesh& mesh,
                std::vector<std::uint32_t>& nearest,
                RoomPoissonReport& report)
{
  mesh = TriangleMesh();
  nearest.clear();
  report.points = points.size();
  if (points.size() < parameters.min_points) {
    report.problem = std::to_string(parameters.min_points) +
                     " points with normals are needed, there are " +
                     std::to_string(points.size());
    return false;
  }
  if (!solve(points, parameters, mesh, report))
    return false;
  compareWithPoints(points, parameters, mesh, nearest, report);
  return true;
}

RoomSurface
surfaceOf(const RoomSamples& samples, const RoomPoissonParameters& parameters)
{
  RoomSurface surface;
  RoomPoissonReport& report = surface.report;
  report.room = samples.room;
  report.skipped_points = samples.skipped;
  report.scaled_normals = samples.scaled;
  TriangleMesh& mesh = surface.mesh;
  std::vector<std::uint32_t> nearest;
  if (reconstructRoom(samples.points, parameters, mesh, nearest, report)) {
    mesh.rooms.assign(mesh.triangles.size(), samples.room);
    if (!samples.labels.empty())
      for (const auto i : nearest)
        mesh.labels.push_back(samples.labels[i]);
  }
  else
    mesh = TriangleMesh();
  if (!samples.problem.empty())
    report.problem = samples.problem;
  return surface;
}

} // namespace pcl::sedr

// SPDX-License-Identifier: BSD-3-Clause
#include "room_support.h"

#include <pcl/sedr_surface/room_poisson.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace sedr {
namespace {

// The octree is turned a little finer or coarser until its surface closes: where leaves
// of two depths meet, pcl::Poisson now and then loses a triangle.
struct Attempt {
  double cell_factor;
  int depth_change;
};
constexpr Attempt attempts[] = {{1, 0},   {1.06, 0}, {0.95, 0}, {1.13, 0},
                                {1.2, 0}, {1, -1},   {1.13, -1}};

// The same points near the origin, where a float has digits to spare.
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

// Depth and scale that give the octree cells of the wanted size: the cube of a plain
// scale would make them anything between that and half of it.
PoissonParameters
fitOctree(const PoissonParameters& limits, double extent, double cell, int depth_change)
{
  PoissonParameters fitted = limits;
  const double least = extent * limits.scale;
  const auto depth = static_cast<int>(std::ceil(std::log2(least / cell) - 1e-9));
  fitted.depth = std::clamp(depth + depth_change, 3, limits.depth);
  fitted.min_depth = std::min(limits.min_depth, fitted.depth);
  const double factor = depth_change < 0 ? std::ldexp(1., -depth_change) : 1.;
  fitted.scale = static_cast<float>(std::max<double>(
      limits.scale, factor * cell * std::ldexp(1., fitted.depth) / extent));
  return fitted;
}

// To where a float puts them: what is checked is what will be written.
void
roundToFloat(TriangleMesh& mesh)
{
  for (Eigen::Vector3d& v : mesh.vertices)
    for (int k = 0; k < 3; ++k) {
      volatile float rounded =
          static_cast<float>(v[k]); // or g++ 12 leaves it out at -O2
      v[k] = static_cast<double>(rounded);
    }
}

// Twice what a float resolves at the far corner of the mesh.
double
resolutionAt(const TriangleMesh& mesh)
{
  const Eigen::AlignedBox3d box = mesh.bounds();
  const double far =
      std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  return 2 * far * std::numeric_limits<float>::epsilon();
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

// What keeps the mesh from being one closed surface, into the report.
void
checkRoom(const TriangleMesh& mesh,
          const RoomPoissonParameters& parameters,
          RoomPoissonReport& report)
{
  report.problem = report.topology.problem();
  if (report.topology.components.size() > 1)
    report.problem += (report.problem.empty() ? "" : ", ") +
                      std::to_string(report.topology.components.size()) + " components";
  else if (report.problem.empty() && hasEqualPositions(mesh))
    report.problem = "vertices at equal positions";
  if (report.repair.open_holes > 0)
    report.problem += ", " + std::to_string(report.repair.open_holes) +
                      (report.repair.open_holes == 1 ? " hole" : " holes") +
                      " of more than " + std::to_string(parameters.max_hole_edges) +
                      " edges";
  report.closed = report.problem.empty();
}

void
repair(TriangleMesh& mesh,
       const RoomPoissonParameters& parameters,
       RoomPoissonReport& report)
{
  MeshRepairOptions options;
  options.max_hole_edges = parameters.max_hole_edges;
  options.keep_components = 1;
  options.shortest_edge = std::max(0.05 * report.cell, 2 * resolutionAt(mesh));
  options.normals = NormalSide::Inward;
  repairMesh(mesh, options, report.repair);
  report.repair.parted_vertices = partEqualPositions(mesh);
  report.topology = checkTopology(mesh);
  checkRoom(mesh, parameters, report);
}

// How far a result is from being closed; of several that are not, the least is kept.
std::size_t
defects(const MeshTopology& topology)
{
  return topology.boundary_edges + topology.non_manifold_edges +
         topology.non_manifold_vertices + topology.inconsistent_edges +
         topology.degenerate_triangles + topology.duplicate_triangles;
}

// One run of screenedPoisson().
bool
solveOnBand(const std::vector<OrientedPoint>& local,
            const Eigen::Vector3d& centre,
            double extent,
            const RoomPoissonParameters& parameters,
            TriangleMesh& mesh,
            RoomPoissonReport& report)
{
  const PoissonParameters octree =
      fitOctree(parameters.solver, extent, report.spacing * parameters.cell_ratio, 0);
  ScreenedPoissonParameters solver;
  solver.cell =
      std::max(report.spacing * parameters.cell_ratio,
               extent * parameters.solver.scale / std::ldexp(1., octree.depth));
  solver.spacing = report.spacing;
  solver.point_weight = parameters.solver.point_weight;
  solver.threads = parameters.threads;
  const std::string failure = screenedPoisson(local, solver, mesh, report.screened);
  report.attempts = 1;
  report.depth = octree.depth;
  report.cell = report.screened.cell;
  report.scale = report.cell * std::ldexp(1., octree.depth) / extent;
  if (!failure.empty()) {
    report.problem = failure;
    return false;
  }
  if (report.cell > 1.001 * solver.cell)
    report.warning = "its cells are " + shortNumber(report.cell) + " m instead of " +
                     shortNumber(solver.cell) + " m, for so large a surface";
  move(mesh, centre);
  keepLargestComponents(mesh, 1, report.repair);
  mesh.removeUnusedVertices();
  report.topology = checkTopology(mesh);
  checkRoom(mesh, parameters, report);
  if (!report.closed) // far from the origin, where a float puts vertices in one place
    repair(mesh, parameters, report);
  return !mesh.empty();
}

// Runs pcl::Poisson until the surface is closed, or as often as is worth it.
bool
solveUntilClosed(const std::vector<OrientedPoint>& local,
                 const Eigen::Vector3d& centre,
                 double extent,
                 const RoomPoissonParameters& parameters,
                 TriangleMesh& mesh,
                 RoomPoissonReport& report)
{
  bool found = false;
  RoomPoissonReport best = report;
  std::string failure;
  for (const Attempt& attempt : attempts) {
    RoomPoissonReport current = report;
    const PoissonParameters octree =
        fitOctree(parameters.solver, extent,
                  report.spacing * parameters.cell_ratio * attempt.cell_factor,
                  attempt.depth_change);
    current.depth = octree.depth;
    current.scale = octree.scale;
    current.cell = extent * octree.scale / std::ldexp(1., octree.depth);
    current.attempts = ++report.attempts;
    TriangleMesh surface;
    failure = solvePoisson(local, octree, surface, current.complaints);
    if (!failure.empty())
      continue;
    move(surface, centre);
    repair(surface, parameters, current);
    if (surface.empty())
      continue;
    if (!found || current.closed ||
        defects(current.topology) < defects(best.topology)) {
      mesh = std::move(surface);
      best = current;
      found = true;
    }
    // Where the surface runs out of the octree, a little more or less of it changes
    // nothing.
    if (best.closed || (best.repair.open_holes > 0 && report.attempts == 3))
      break;
  }
  best.attempts = report.attempts;
  report = best;
  if (!found)
    report.problem = failure.empty() ? "nothing was left of the surface" : failure;
  return found;
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
  return parameters.method == PoissonSolver::Sedr
             ? solveOnBand(local, centre, extent, parameters, mesh, report)
             : solveUntilClosed(local, centre, extent, parameters, mesh, report);
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

} // namespace sedr
} // namespace pcl

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/mesh_repair.h>
#include <pcl/sedr_surface/poisson_solver.h>
#include <pcl/sedr_surface/screened_poisson.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief What solves the screened Poisson equation. */
enum class PoissonSolver {
  Sedr, ///< screenedPoisson(): cells along the surface, repeatable with any threads
  Pcl   ///< pcl::Poisson, tried until its surface closes
};

/** @brief How the surface of a room is made; see StructuralPoisson. */
struct RoomPoissonParameters {
  PoissonSolver method = PoissonSolver::Sedr;
  PoissonParameters solver;     ///< `depth` is a maximum, `scale` a minimum
  double cell_ratio = 0.8;      ///< finest cell of the octree / spacing of the points
  std::size_t min_points = 100; ///< a room of fewer is not tried
  std::size_t max_hole_edges = 64; ///< longer holes in the surface are not filled
  double support_distance =
      0.3;              ///< metres; further from all points, a surface is a guess
  unsigned threads = 1; ///< for what is repeatable with any number of them

  RoomPoissonParameters() { solver.point_weight = 10; }
};

/** @brief What became of a room. */
struct RoomPoissonReport {
  std::uint32_t room = 0;
  std::size_t points = 0;         ///< used
  std::size_t skipped_points = 0; ///< not finite, or without a normal
  std::size_t scaled_normals = 0; ///< of another length than 1, made unit length
  double spacing = 0;             ///< of the points, metres
  int depth = 0;                  ///< of the octree
  double scale = 0;               ///< edge of the octree's cube / extent of the points
  double cell = 0;                ///< edge of its finest cell, metres
  int attempts = 0;               ///< runs of the solver
  ScreenedPoissonReport screened; ///< of Sedr's
  std::size_t complaints = 0; ///< lines that pcl::Poisson would have printed, last run
  MeshRepairReport repair;    ///< of the last run
  MeshTopology topology;      ///< of the result
  bool closed = false;        ///< closed, manifold, oriented, one component
  double area = 0;            ///< square metres
  double volume = 0;          ///< cubic metres, above zero
  double unsupported_share = 0; ///< share of the area far from all points
  std::string
      problem; ///< why there is no surface or what keeps it from being closed, or empty
  std::string warning; ///< what to know of a surface that is closed, or empty
};

/** @brief The surface of one room by screened Poisson: solved near the origin, its
 * largest component kept, repaired, and solved again a little differently until it is
 * closed.
 *
 * @param points finite, with unit normals into the room
 * @param parameters in range
 * @param mesh the surface, its normals on the side of those of the points; empty
 * without one
 * @param nearest for each triangle the index of the point nearest to its middle
 * @param report what was done; `room`, `skipped_points` and `scaled_normals` stay as
 * they are
 * @return true if there is a surface; it is closed if report.closed */
bool reconstructRoom(const std::vector<OrientedPoint>& points,
                     const RoomPoissonParameters& parameters,
                     TriangleMesh& mesh,
                     std::vector<std::uint32_t>& nearest,
                     RoomPoissonReport& report);

/** @brief The points that the surface of a room is made of. */
struct RoomSamples {
  std::uint32_t room = 0;
  std::vector<OrientedPoint> points; ///< finite, with unit normals into the room
  std::vector<std::uint32_t> labels; ///< of each of them, or empty
  std::size_t skipped = 0; ///< points left out: not finite, or without a normal
  std::size_t scaled = 0;  ///< normals that were of another length than 1
  std::string problem;     ///< what is wrong with the samples themselves, or empty
};

/** @brief The surface of a room, with room and label of every triangle, and what became
 * of it. */
struct RoomSurface {
  TriangleMesh mesh; ///< empty without a surface
  RoomPoissonReport report;
};

/** @brief The surface of a room from its samples; parameters in range. */
RoomSurface surfaceOf(const RoomSamples& samples,
                      const RoomPoissonParameters& parameters);

} // namespace sedr
} // namespace pcl

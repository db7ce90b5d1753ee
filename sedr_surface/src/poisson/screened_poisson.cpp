// SPDX-License-Identifier: BSD-3-Clause
#include "../isosurface/dual_surface.h"
#include "../solver/poisson_level.h"

#include "screened_poisson.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace pcl::sedr {
namespace {

// Blocks of 512 nodes in a band per block that contains samples.
constexpr double band_blocks = 2.5;

// For slivers and edge collapses, in cells.
constexpr double min_height = 0.02;
constexpr double longest_collapse = 1.5;

// Returns the origin of the grid, less than a cell below `low`. It maximises the
// distance of nodes from faces normal to each axis, where values are near zero and of
// either sign.
Eigen::Vector3d
gridOrigin(const std::vector<OrientedPoint>& points,
           const Eigen::Vector3d& low,
           double cell)
{
  constexpr int bins = 32; // per cell
  Eigen::Vector3d origin = low;
  for (int k = 0; k < 3; ++k) {
    std::array<int, bins> counts{};
    for (const OrientedPoint& p : points)
      if (std::abs(p.normal[k]) > 0.99f) {
        const double place = (static_cast<double>(p.position[k]) - low[k]) / cell;
        ++counts[static_cast<std::size_t>((place - std::floor(place)) * bins) % bins];
      }
    double best = -1;
    for (std::size_t node = 0; node < bins; ++node) {
      double crowd = 0;
      for (std::size_t i = 0; i < bins; ++i) {
        const double apart = std::abs(
            std::remainder(static_cast<double>(i) + 0.5 - static_cast<double>(node),
                           static_cast<double>(bins)));
        crowd += counts[i] * std::pow(0.7, apart);
      }
      if (best < 0 || crowd < best) {
        best = crowd;
        origin[k] = low[k] + cell * (static_cast<double>(node) / bins - 1);
      }
    }
  }
  return origin;
}

// Returns true if the normals point away from the volume enclosed by the points.
bool
facesOutwards(const std::vector<SurfaceSample>& samples)
{
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const SurfaceSample& sample : samples)
    centre += sample.position / static_cast<double>(samples.size());
  double volume = 0;
  for (const SurfaceSample& sample : samples)
    volume += sample.normal.cast<double>().dot(sample.position - centre);
  return volume > 0;
}

} // namespace

std::string
screenedPoisson(const std::vector<OrientedPoint>& points,
                ScreenedPoissonParameters& parameters,
                TriangleMesh& mesh)
{
  mesh = TriangleMesh();
  if (points.size() < 3)
    return "screened Poisson needs at least 3 points, there are " +
           std::to_string(points.size());
  Eigen::AlignedBox3d box;
  for (const OrientedPoint& p : points)
    box.extend(p.position.cast<double>());
  double& cell = parameters.cell;
  std::vector<SurfaceSample> samples;
  samples.reserve(points.size());
  Eigen::Vector3d origin;
  for (;;) {
    origin = gridOrigin(points, box.min(), cell);
    samples.clear();
    for (const OrientedPoint& p : points) // in cells
      samples.push_back({(p.position.cast<double>() - origin) / cell, p.normal, 1});
    setAreas(samples, parameters.spacing / cell);
    const double expected =
        band_blocks *
        static_cast<double>(sortSamples(samples, 1).grid.size() * BandGrid::nodes);
    const double most = static_cast<double>(parameters.max_nodes);
    if (expected <= most)
      break;
    cell *= 1.05 * std::sqrt(expected / most);
  }
  const bool outwards = facesOutwards(samples);
  if (outwards)
    for (SurfaceSample& sample : samples)
      sample.normal = -sample.normal;
  PoissonSolution solution = solvePoisson(
      samples, 2 * parameters.max_nodes / BandGrid::nodes, parameters.threads);
  if (!solution.problem.empty())
    return solution.problem;
  const BandGrid& grid = solution.level.grid();
  std::vector<float>& values = solution.level.values;
  const auto iso = static_cast<float>(solution.mean);
  for (std::size_t i = 0; i < grid.size() * BandGrid::nodes; ++i) {
    values[i] -= iso;
    if (std::abs(values[i]) < 1e-4f)
      values[i] = values[i] > 0 ? 1e-4f : -1e-4f;
  }
  makeWellComposed(grid, values, parameters.threads);
  std::vector<SurfaceVertex> vertices;
  extractDualSurface(grid, values, solution.level.samples(),
                     static_cast<float>(1.5 * parameters.spacing / cell),
                     parameters.threads, mesh, vertices);
  mendSurface(mesh, vertices, min_height, longest_collapse);
  for (Eigen::Vector3d& v : mesh.vertices)
    v = origin + cell * v;
  if (outwards)
    mesh.flip();
  return mesh.empty() ? "the points have no surface" : "";
}

} // namespace pcl::sedr

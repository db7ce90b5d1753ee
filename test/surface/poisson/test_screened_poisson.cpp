// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_surface/src/poisson/screened_poisson.h"
#include <pcl/sedr_surface/impl/room_samples.h>
#include <pcl/sedr_surface/mesh_topology.h>
#include <pcl/sedr_surface/structural_poisson.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace pcl::sedr;

namespace {

/** Points of a sphere in a spiral, `spacing` apart, normals outwards. */
std::vector<OrientedPoint>
sphere(const Eigen::Vector3d& centre, double radius, double spacing)
{
  const double area = 4 * M_PI * radius * radius;
  const auto n = static_cast<int>(area / (spacing * spacing));
  std::vector<OrientedPoint> points;
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2 * i + 1) / static_cast<double>(n);
    const double turn = 2.399963229728653 * i; // the golden angle
    const double r = std::sqrt(1 - z * z);
    const Eigen::Vector3d normal(r * std::cos(turn), r * std::sin(turn), z);
    points.push_back({(centre + radius * normal).cast<float>(), normal.cast<float>()});
  }
  return points;
}

/** Points of a box with a corner at the origin, normals outwards. */
std::vector<OrientedPoint>
box(const Eigen::Vector3d& size, double spacing)
{
  std::vector<OrientedPoint> points;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const auto nu = static_cast<int>(std::lround(size[u] / spacing));
    const auto nv = static_cast<int>(std::lround(size[v] / spacing));
    for (int i = 0; i < nu; ++i)
      for (int j = 0; j < nv; ++j)
        for (int side = 0; side < 2; ++side) {
          Eigen::Vector3d place;
          place[axis] = side * size[axis];
          place[u] = (i + 0.5) * size[u] / nu;
          place[v] = (j + 0.5) * size[v] / nv;
          points.push_back(
              {place.cast<float>(), Eigen::Vector3f::Unit(axis) * (side ? 1.f : -1.f)});
        }
  }
  return points;
}

ScreenedPoissonParameters
cellsOf(double cell, double spacing)
{
  ScreenedPoissonParameters parameters;
  parameters.cell = cell;
  parameters.spacing = spacing;
  return parameters;
}

TriangleMesh
solve(const std::vector<OrientedPoint>& points, ScreenedPoissonParameters parameters)
{
  TriangleMesh mesh;
  EXPECT_EQ(screenedPoisson(points, parameters, mesh), "");
  return mesh;
}

void
expectClosed(const TriangleMesh& mesh, std::size_t components, std::int64_t euler)
{
  const MeshTopology topology = checkTopology(mesh);
  EXPECT_TRUE(topology.isClosedManifold()) << topology.problem();
  EXPECT_EQ(topology.components.size(), components);
  EXPECT_EQ(topology.euler_characteristic, euler);
}

// Returns the maximum distance of a vertex from the sphere.
double
worstRadius(const TriangleMesh& mesh, const Eigen::Vector3d& centre, double radius)
{
  double worst = 0;
  for (const auto& v : mesh.vertices)
    worst = std::max(worst, std::abs((v - centre).norm() - radius));
  return worst;
}

} // namespace

TEST(ScreenedPoisson, a_sphere_comes_back_and_smaller_cells_are_more_exact)
{
  const Eigen::Vector3d centre(0.3, -0.2, 0.7);
  double before = 1;
  for (const double spacing : {0.16, 0.08, 0.04}) {
    const auto mesh =
        solve(sphere(centre, 1, spacing), cellsOf(0.8 * spacing, spacing));
    expectClosed(mesh, 1, 2);
    EXPECT_GT(mesh.signedVolume(), 0); // normals outwards
    const double error = worstRadius(mesh, centre, 1);
    EXPECT_LT(error, 0.1 * spacing * spacing);
    EXPECT_LT(error, 0.5 * before);
    EXPECT_NEAR(mesh.signedVolume(), 4 * M_PI / 3, spacing * spacing);
    before = error;
  }
}

TEST(ScreenedPoisson, whatever_the_points_the_surface_is_closed_or_there_is_none)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<float> any(-1, 1);
  int surfaces = 0;
  for (int run = 0; run < 12; ++run) {
    std::vector<OrientedPoint> points;
    for (int i = 0; i < 50 << (run % 4); ++i) {
      const Eigen::Vector3f normal(any(random), any(random), any(random));
      points.push_back({{any(random), any(random), any(random)}, normal.normalized()});
    }
    TriangleMesh mesh;
    auto parameters = cellsOf(0.05, 0.1);
    const std::string problem = screenedPoisson(points, parameters, mesh);
    EXPECT_EQ(mesh.empty(), !problem.empty());
    if (mesh.empty())
      continue;
    ++surfaces;
    EXPECT_TRUE(checkTopology(mesh).isClosedManifold())
        << checkTopology(mesh).problem();
  }
  EXPECT_GT(surfaces, 0);
}

TEST(ScreenedPoisson, a_gap_in_the_points_is_closed)
{
  auto points = sphere({0, 0, 0}, 1, 0.06);
  points.erase(std::remove_if(points.begin(), points.end(),
                              [](const auto& p) { return p.position.z() > 0.85f; }),
               points.end());
  const auto mesh = solve(points, cellsOf(0.048, 0.06));
  expectClosed(mesh, 1, 2);
  EXPECT_NEAR(mesh.signedVolume(), 4 * M_PI / 3, 0.15);
}

TEST(ScreenedPoisson, where_nodes_run_out_the_cells_become_larger)
{
  auto parameters = cellsOf(0.02, 0.05);
  parameters.max_nodes = 100000;
  TriangleMesh mesh;
  EXPECT_EQ(screenedPoisson(sphere({0, 0, 0}, 1, 0.05), parameters, mesh), "");
  expectClosed(mesh, 1, 2);
  EXPECT_GT(parameters.cell, 0.03);
  EXPECT_LT(worstRadius(mesh, {0, 0, 0}, 1), 0.02);
}

namespace {

// A plate of the given thickness, turned about an axis oblique to the grid.
std::vector<OrientedPoint>
turnedPlate(double thickness, double angle, double spacing)
{
  const Eigen::AngleAxisf turn(static_cast<float>(angle),
                               Eigen::Vector3f(1, 2, 3).normalized());
  auto points = box({1, 0.7, thickness}, spacing);
  for (OrientedPoint& p : points) {
    p.position = turn * p.position;
    p.normal = turn * p.normal;
  }
  return points;
}

} // namespace

TEST(ScreenedPoisson, a_thin_plate_is_closed_and_without_holes_from_a_cell_on)
{
  constexpr double spacing = 0.05;
  for (const double thickness : {0.015, 0.03, 0.05, 0.07})
    for (const double angle : {0., 0.3, 1.1}) {
      SCOPED_TRACE("thickness " + std::to_string(thickness) + ", turned by " +
                   std::to_string(angle));
      const auto points = turnedPlate(thickness, angle, spacing);
      const auto mesh = solve(points, cellsOf(0.8 * spacing, spacing));
      if (thickness < spacing) {
        EXPECT_TRUE(checkTopology(mesh).isClosedManifold());
        continue;
      }
      expectClosed(mesh, 1, 2);
      EXPECT_NEAR(mesh.signedVolume(), 0.7 * thickness, 0.7 * 0.01);
    }
}

TEST(ScreenedPoisson, a_slot_thinner_than_a_cell_stays_open)
{
  // The same plates as air in a block.
  constexpr double spacing = 0.05;
  for (const double thickness : {0.03, 0.05}) {
    auto points = box({1, 0.7, thickness}, spacing);
    for (OrientedPoint& p : points)
      p.normal = -p.normal;
    for (OrientedPoint p : box({2, 1.7, 1}, spacing)) {
      p.position -= Eigen::Vector3f(0.5f, 0.5f, 0.5f);
      points.push_back(p);
    }
    const auto mesh = solve(points, cellsOf(0.8 * spacing, spacing));
    expectClosed(mesh, 2, 4);
  }
}

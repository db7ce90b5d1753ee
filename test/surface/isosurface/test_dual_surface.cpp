// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_surface/src/isosurface/dual_surface.h"
#include "sedr_surface/src/isosurface/sign_repair.h"
#include "sedr_surface/src/isosurface/surface_mending.h"

#include <pcl/sedr_surface/mesh_topology.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace pcl::sedr;

namespace {

// Returns the blocks of a cube with `edge` blocks per side.
BandGrid
cubeOfBlocks(std::int64_t edge)
{
  std::vector<BandGrid::Key> keys;
  for (std::int64_t i = 0; i < edge * edge * edge; ++i)
    keys.push_back(
        BandGrid::keyOf({i % edge - 1, i / edge % edge - 1, i / edge / edge - 1}));
  return BandGrid(keys);
}

template <typename Function>
std::vector<float>
valuesOf(const BandGrid& grid, Function function)
{
  std::vector<float> values(grid.valueCount(), 0.f);
  for (std::size_t b = 0; b < grid.size(); ++b) {
    const BandGrid::Block block = grid.at(b);
    for (int z = 0; z < 8; ++z)
      for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
          values[b * BandGrid::nodes + BandGrid::nodeIndex(x, y, z)] =
              function(Eigen::Vector3d(static_cast<double>(8 * block[0] + x),
                                       static_cast<double>(8 * block[1] + y),
                                       static_cast<double>(8 * block[2] + z)));
  }
  return values;
}

TriangleMesh
extract(const BandGrid& grid, const std::vector<float>& values)
{
  TriangleMesh mesh;
  std::vector<SurfaceVertex> vertices;
  SortedSamples none;
  none.starts.push_back(0);
  extractDualSurface(grid, values, none, 2, 1, mesh, vertices);
  return mesh;
}

// Returns true inside the blocks of a cube of three per side, two nodes off its rim.
bool
isInside(const Eigen::Vector3d& p)
{
  return (p.array() > -6).all() && (p.array() < 13).all();
}

} // namespace

TEST(BandGrid, finds_its_blocks_and_their_neighbours_on_both_sides_of_zero)
{
  const BandGrid grid = cubeOfBlocks(3);
  ASSERT_EQ(grid.size(), 27u);
  for (std::size_t b = 0; b < grid.size(); ++b)
    EXPECT_EQ(grid.find(grid.at(b)), b);
  EXPECT_EQ(grid.find({2, 0, 0}), grid.size());
  const std::size_t middle = grid.find({0, 0, 0});
  EXPECT_EQ(grid.at(grid.neighbour(middle, -1, 1, 0)), (BandGrid::Block{-1, 1, 0}));
  EXPECT_FALSE(grid.atRim(middle));
  EXPECT_TRUE(grid.atRim(grid.find({1, 1, 1})));
}

TEST(BandGrid, a_halo_holds_the_nodes_around_a_block)
{
  const BandGrid grid = cubeOfBlocks(3);
  const auto number = [](const Eigen::Vector3d& p) {
    return static_cast<float>(p.x() + 40 * p.y() + 1600 * p.z());
  };
  const auto values = valuesOf(grid, number);
  float halo[BandGrid::halo_nodes];
  grid.gatherHalo(values, grid.find({0, 0, 0}), halo);
  for (int z = -1; z <= 8; ++z)
    for (int y = -1; y <= 8; ++y)
      for (int x = -1; x <= 8; ++x)
        ASSERT_EQ(halo[BandGrid::haloIndex(x, y, z)], number({x * 1., y * 1., z * 1.}));
}

TEST(DualSurface, a_ball_without_samples_is_where_its_values_say)
{
  const BandGrid grid = cubeOfBlocks(3);
  const Eigen::Vector3d centre(3.4, 3.7, 4.1);
  const auto mesh = extract(grid, valuesOf(grid, [&](const Eigen::Vector3d& p) {
                              return static_cast<float>(7.3 - (p - centre).norm());
                            }));
  const MeshTopology topology = checkTopology(mesh);
  EXPECT_TRUE(topology.isClosedManifold()) << topology.problem();
  EXPECT_EQ(topology.euler_characteristic, 2);
  EXPECT_LT(mesh.signedVolume(), 0); // normals towards values above zero
  for (const auto& v : mesh.vertices)
    EXPECT_NEAR((v - centre).norm(), 7.3, 0.1);
}

TEST(DualSurface, whatever_the_values_their_surface_is_closed_and_manifold)
{
  const BandGrid grid = cubeOfBlocks(3);
  for (unsigned seed = 1; seed <= 5; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> any(-1, 1);
    auto values = valuesOf(grid, [&](const Eigen::Vector3d& p) {
      const float value = any(random);
      return isInside(p) ? value : -1.f;
    });
    EXPECT_FALSE(checkTopology(extract(grid, values)).isClosedManifold())
        << "the case proves nothing";
    EXPECT_GT(makeWellComposed(grid, values, 2), 0u);
    const auto mesh = extract(grid, values);
    EXPECT_FALSE(mesh.empty());
    EXPECT_TRUE(checkTopology(mesh).isClosedManifold())
        << checkTopology(mesh).problem();
  }
}

TEST(DualSurface, well_composed_values_stay_as_they_are)
{
  const BandGrid grid = cubeOfBlocks(3);
  auto values = valuesOf(grid, [](const Eigen::Vector3d& p) {
    return static_cast<float>(6.1 - (p - Eigen::Vector3d(4, 4, 4)).norm());
  });
  const auto before = values;
  EXPECT_EQ(makeWellComposed(grid, values, 1), 0u);
  EXPECT_EQ(values, before);
}

TEST(SurfaceMending, a_fold_in_a_face_is_taken_out)
{
  // A box with its top at 6.5, with one vertex two cells away from its position.
  const BandGrid grid = cubeOfBlocks(3);
  const auto values = valuesOf(grid, [](const Eigen::Vector3d& p) {
    const Eigen::Array3d off = (p - Eigen::Vector3d(3.5, 3.5, 3)).array().abs();
    return static_cast<float>(off.maxCoeff() - 3.5);
  });
  TriangleMesh mesh;
  std::vector<SurfaceVertex> vertices;
  SortedSamples none;
  none.starts.push_back(0);
  extractDualSurface(grid, values, none, 2, 1, mesh, vertices);
  ASSERT_TRUE(checkTopology(mesh).isClosedManifold()) << checkTopology(mesh).problem();
  const double volume = mesh.signedVolume();
  const auto onTop = [&mesh](std::uint32_t v) {
    return std::abs(mesh.vertices[v].z() - 6.5) < 1e-6;
  };
  const auto folds = [&] {
    std::size_t count = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Triangle& triangle = mesh.triangles[t];
      count += std::all_of(triangle.begin(), triangle.end(), onTop) &&
               mesh.scaledNormal(t).z() <= 0;
    }
    return count;
  };
  ASSERT_EQ(folds(), 0u);
  std::uint32_t middle = 0;
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v)
    if (onTop(v) && (mesh.vertices[v] - Eigen::Vector3d(3.5, 3.5, 6.5)).norm() < 0.6)
      middle = v;
  ASSERT_TRUE(onTop(middle));
  mesh.vertices[middle] += Eigen::Vector3d(1.8, 0.3, 0);
  ASSERT_GT(folds(), 0u);
  mendSurface(mesh, vertices, 0.02, 1.5);
  EXPECT_EQ(folds(), 0u);
  EXPECT_TRUE(checkTopology(mesh).isClosedManifold()) << checkTopology(mesh).problem();
  EXPECT_NEAR(mesh.signedVolume(), volume, 0.01 * std::abs(volume));
}

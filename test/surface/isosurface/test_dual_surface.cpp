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

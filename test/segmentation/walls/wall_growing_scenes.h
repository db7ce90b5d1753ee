// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace wall_growing {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Growing = pcl::CeilingBoundaryWallGrowing<pcl::PointXYZ>;

constexpr float step = 0.0625f; // multiples add and subtract without rounding

inline pcl::IndicesPtr
indexList(pcl::Indices indices = {})
{
  return pcl::make_shared<pcl::Indices>(std::move(indices));
}

/** @brief A cloud that is built part by part; each part returns its indices. */
struct Scene {
  Cloud::Ptr cloud = pcl::make_shared<Cloud>();

  pcl::index_t add(float x, float y, float z)
  {
    cloud->push_back({x, y, z});
    return static_cast<pcl::index_t>(cloud->size() - 1);
  }

  /** @brief Adds points every step over [x0, x1] x [y0, y1] at height z, where `keep`
   * returns true. */
  template <typename Keep>
  pcl::Indices slab(float x0, float x1, float y0, float y1, float z, Keep keep)
  {
    pcl::Indices indices;
    for (float y = y0; y <= y1; y += step)
      for (float x = x0; x <= x1; x += step)
        if (keep(x, y))
          indices.push_back(add(x, y, z));
    return indices;
  }

  pcl::Indices slab(float x0, float x1, float y0, float y1, float z)
  {
    return slab(x0, x1, y0, y1, z, [](float, float) { return true; });
  }

  /** @brief Adds a vertical line of points every step over [z0, z1]. */
  pcl::Indices pole(float x, float y, float z0, float z1)
  {
    pcl::Indices indices;
    for (float z = z0; z <= z1; z += step)
      indices.push_back(add(x, y, z));
    return indices;
  }
};

/** @brief Returns the union of both lists in ascending order. */
inline pcl::Indices
united(pcl::Indices a, const pcl::Indices& b)
{
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end());
  a.erase(std::unique(a.begin(), a.end()), a.end());
  return a;
}

inline Growing
growingOn(const Scene& scene, const pcl::Indices& ceiling)
{
  Growing growing;
  growing.setDistanceThreshold(0.1); // 1.6 times the point spacing
  growing.setInputCloud(scene.cloud);
  growing.setCeilingIndices(indexList(ceiling));
  return growing;
}

inline pcl::Indices
wallsOf(Growing& growing)
{
  pcl::PointIndices walls;
  EXPECT_TRUE(growing.segment(walls)) << growing.getErrorMessage();
  return walls.indices;
}

/** @brief Returns a ceiling of irregular spacing with a round hole, as in a scan. */
inline Scene
irregularCeiling(unsigned int seed, int columns = 70, int points_a_spot = 1)
{
  Scene scene;
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> jitter(-0.02f, 0.02f);
  std::normal_distribution<float> noise(0.f, 0.01f);
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < 50; ++j) {
      const float x = static_cast<float>(i) * 0.05f + jitter(random);
      const float y = static_cast<float>(j) * 0.05f + jitter(random);
      if (std::hypot(x - 1.7f, y - 1.2f) < 0.4f)
        continue;
      const float z = 2.5f + noise(random);
      for (int n = 0; n < points_a_spot; ++n)
        scene.add(x, y, z);
    }
  return scene;
}

inline pcl::Indices
allOf(const Scene& scene)
{
  pcl::Indices all(scene.cloud->size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = static_cast<pcl::index_t>(i);
  return all;
}

/** @brief A room of 4 m x 3 m x 2.5 m whose ceiling is 0.75 m lower for x > 3. The step
 * is larger than the neighbourhood of a ceiling point, so both parts are connected only
 * in plan. */
struct SoffitRoom : Scene {
  pcl::Indices ceiling = slab(0, 3, 0, 3, 2.5f);
  pcl::Indices soffit = slab(3, 4, 0, 3, 1.75f);
  pcl::Indices floor = slab(0, 4, 0, 3, 0.f);
  pcl::Indices wall_above = pole(4 + step, 1.5f, 1.5625f, 1.6875f);
  pcl::Indices wall_below = pole(4 + step, 1.5f, 0.25f, 1.4375f);
  pcl::Indices by_riser_above = pole(3, 1.5f, 1.5625f, 1.6875f);
  pcl::Indices by_riser_below = pole(3, 1.5f, 0.25f, 1.4375f);

  Growing growing() const
  {
    Growing growing = growingOn(*this, ceiling);
    growing.setFloorIndices(indexList(floor));
    growing.setDetailIndices(indexList(soffit));
    growing.setSliceHeight(1.5);
    return growing;
  }
};

} // namespace wall_growing

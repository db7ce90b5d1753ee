// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <pcl/features/boundary.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Growing = pcl::CeilingBoundaryWallGrowing<pcl::PointXYZ>;

constexpr float step = 0.0625f; // multiples add and subtract without rounding

pcl::IndicesPtr
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
pcl::Indices
united(pcl::Indices a, const pcl::Indices& b)
{
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end());
  a.erase(std::unique(a.begin(), a.end()), a.end());
  return a;
}

Growing
growingOn(const Scene& scene, const pcl::Indices& ceiling)
{
  Growing growing;
  growing.setDistanceThreshold(0.1); // 1.6 times the point spacing
  growing.setInputCloud(scene.cloud);
  growing.setCeilingIndices(indexList(ceiling));
  return growing;
}

pcl::Indices
wallsOf(Growing& growing)
{
  pcl::PointIndices walls;
  EXPECT_TRUE(growing.segment(walls)) << growing.getErrorMessage();
  return walls.indices;
}

/** @brief Returns a ceiling of irregular spacing with a round hole, as in a scan. */
Scene
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

pcl::Indices
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

TEST(CeilingBoundaryWallGrowing, WallsAreExactlyThePointsWithinTheDistance)
{
  Scene scene;
  const auto ceiling = scene.slab(0, 2, 0, 2, 2.5f);
  const auto at_distance = scene.pole(2.125f, 1, 0, 2);
  scene.pole(std::nextafter(2.125f, 3.f), 1, 0, 2);
  const auto at_corner = scene.pole(2.09375f, 2.0625f, 0, 2); // 0.1127 from the corner
  scene.pole(2.09375f, 2.09375f, 0, 2);                       // 0.1326
  scene.pole(1, 1, 0, 2);                                     // amid the room
  Growing growing = growingOn(scene, ceiling);
  growing.setDistanceThreshold(0.125);
  EXPECT_EQ(wallsOf(growing), united(at_distance, at_corner));
  EXPECT_EQ(growing.getWallIndices(), united(at_distance, at_corner));
}

TEST(CeilingBoundaryWallGrowing, WallsAreThoseOfASearchOverAllSeeds)
{
  Scene scene = irregularCeiling(3);
  const auto ceiling = allOf(scene);
  std::mt19937 random(7);
  std::uniform_real_distribution<float> coordinate(-1.f, 4.f);
  for (int i = 0; i < 20000; ++i)
    scene.add(coordinate(random), coordinate(random), coordinate(random));
  for (const double distance : {0.001, 0.05, 0.1, 0.7}) {
    Growing growing = growingOn(scene, ceiling);
    growing.setDistanceThreshold(distance);
    const auto walls = wallsOf(growing);

    pcl::Indices expected;
    for (std::size_t i = ceiling.size(); i < scene.cloud->size(); ++i) {
      const auto p = (*scene.cloud)[i].getVector3fMap().head<2>().cast<double>();
      const auto isNear = [&](pcl::index_t seed) {
        const auto& s = (*scene.cloud)[static_cast<std::size_t>(seed)];
        return (s.getVector3fMap().head<2>().cast<double>() - p).norm() <= distance;
      };
      const auto& seeds = growing.getBoundaryIndices();
      if (std::any_of(seeds.begin(), seeds.end(), isNear))
        expected.push_back(static_cast<pcl::index_t>(i));
    }
    EXPECT_EQ(walls, expected) << distance << " m";
  }
}

TEST(CeilingBoundaryWallGrowing, SliceDividesSeedsOfCeilingAndScopeFromThoseOfTheFloor)
{
  const SoffitRoom room;
  Growing growing = room.growing();
  const auto walls =
      united(united(room.wall_above, room.wall_below), room.by_riser_above);
  EXPECT_EQ(wallsOf(growing), united(walls, room.soffit));
  EXPECT_EQ(growing.getWallIndices(), walls);

  // The soffit's edge is a boundary of the ceiling, but not of scope or floor.
  EXPECT_EQ(growing.getBoundaryIndices().size(), 4u * 48u);
  EXPECT_EQ(growing.getFloorBoundaryIndices().size(), 2u * 48u + 2u * 64u);
  for (const auto i : growing.getScopeBoundaryIndices()) {
    const auto& p = (*room.cloud)[static_cast<std::size_t>(i)];
    EXPECT_TRUE(p.x == 0 || p.x == 4 || p.y == 0 || p.y == 3) << p;
  }
  EXPECT_GE(growing.getScopeBoundaryIndices().size(), 2u * 48u + 2u * 64u);
}

TEST(CeilingBoundaryWallGrowing, WithoutSliceTheCeilingAloneSeedsAndDetailsHaveNoEffect)
{
  const SoffitRoom room;
  Growing growing = room.growing();
  growing.setSliceHeight(std::numeric_limits<double>::quiet_NaN());
  auto expected = united(room.by_riser_above, room.by_riser_below);
  for (const auto i : room.soffit)
    if ((*room.cloud)[static_cast<std::size_t>(i)].x <= 3 + step)
      expected.push_back(i);
  EXPECT_EQ(wallsOf(growing), united(expected, {}));
  EXPECT_TRUE(growing.getScopeBoundaryIndices().empty());
  EXPECT_TRUE(growing.getFloorBoundaryIndices().empty());
}

TEST(CeilingBoundaryWallGrowing, DetailsJoinTheWallsThoughTheyAreNoCandidates)
{
  const SoffitRoom room;
  Growing growing = room.growing();
  growing.setIndices(indexList(room.wall_below));
  EXPECT_EQ(wallsOf(growing), united(room.wall_below, room.soffit));
}

TEST(CeilingBoundaryWallGrowing, FarFromTheOriginTheRoomIsTheSame)
{
  Scene near_by, far_away;
  const float x = 10240, y = -10240; // floats there are 1 / 1024 m apart
  const auto ceiling = near_by.slab(0, 2, 0, 2, 2.5f);
  near_by.pole(2.0625f, 1, 0, 2);
  near_by.pole(2.1875f, 1, 0, 2);
  for (const auto& p : *near_by.cloud)
    far_away.add(p.x + x, p.y + y, p.z);
  far_away.add(-1e15f, 1e15f, 0); // too far for a 32-bit cell of 0.1 m
  Growing growing = growingOn(near_by, ceiling);
  const auto walls = wallsOf(growing);
  growing.setInputCloud(far_away.cloud);
  EXPECT_EQ(wallsOf(growing), walls);
}

TEST(CeilingBoundaryWallGrowing, BadInputIsRefusedWithAReasonAndClearsTheResult)
{
  const SoffitRoom room;
  const auto refusesWith = [&](auto change, const char* word) {
    Growing growing = room.growing();
    change(growing);
    pcl::PointIndices walls;
    walls.indices = {1, 2, 3};
    EXPECT_FALSE(growing.segment(walls)) << word;
    EXPECT_TRUE(walls.indices.empty()) << word;
    EXPECT_TRUE(growing.getBoundaryIndices().empty()) << word;
    EXPECT_NE(growing.getErrorMessage().find(word), std::string::npos)
        << growing.getErrorMessage();
  };
  refusesWith([](Growing& g) { g.setInputCloud(pcl::make_shared<Cloud>()); },
              "0 points");
  refusesWith([](Growing& g) { g.setFloorIndices(indexList({99999})); }, "index 99999");
  refusesWith([](Growing& g) { g.setCeilingIndices(nullptr); }, "there are 0");
  refusesWith(
      [](Growing& g) {
        g.setCeilingIndices(indexList({0, 1, 1}));
      },
      "there are 2");
  refusesWith([](Growing& g) { g.setFloorIndices(indexList()); }, "floor");
  refusesWith([](Growing& g) { g.setSliceHeight(HUGE_VAL); }, "slice");
}

pcl::Indices
boundaryByPcl(const Cloud::Ptr& cloud, int neighbours, float angle)
{
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>(
      cloud->size(), 1, pcl::Normal(0.f, 0.f, 1.f));
  pcl::BoundaryEstimation<pcl::PointXYZ, pcl::Normal, pcl::Boundary> estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(normals);
  estimation.setKSearch(neighbours);
  estimation.setAngleThreshold(angle);
  pcl::PointCloud<pcl::Boundary> result;
  estimation.compute(result);
  pcl::Indices boundary;
  for (std::size_t i = 0; i < result.size(); ++i)
    if (result[i].boundary_point)
      boundary.push_back(static_cast<pcl::index_t>(i));
  return boundary;
}

TEST(CeilingBoundaryWallGrowing, BoundaryIsThatOfPclBoundaryEstimation)
{
  struct Case {
    Scene scene;
    int neighbours;
    float degrees;
    std::size_t least; ///< points of the boundary
  };
  Scene high_step;
  high_step.slab(0, 2.95f, 0, 4, 2.5f);
  high_step.slab(3, 6, 0, 4, 3.3f);
  for (const Case& c : {Case{irregularCeiling(200), 200, 60, 250},
                        Case{irregularCeiling(100), 100, 90, 250},
                        Case{irregularCeiling(40), 40, 45, 250},
                        Case{irregularCeiling(12), 12, 75, 250},
                        // of which the nearest 40 points coincide
                        Case{irregularCeiling(5, 15, 40), 400, 60, 40 * 100},
                        Case{high_step, 200, 60, 250}}) {
    Growing growing = growingOn(c.scene, allOf(c.scene));
    growing.setNumberOfNeighbors(static_cast<unsigned int>(c.neighbours));
    growing.setAngleThreshold(c.degrees * static_cast<float>(M_PI) / 180.f);
    wallsOf(growing);
    const auto expected =
        boundaryByPcl(c.scene.cloud, c.neighbours, growing.getAngleThreshold());
    EXPECT_GT(expected.size(), c.least);
    EXPECT_EQ(growing.getBoundaryIndices(), expected) << c.neighbours << " neighbours";
  }
}

} // namespace

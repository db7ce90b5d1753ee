// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_test.h"

#include "sedr_filters/src/voxels/voxel_visit.h"

#include <gtest/gtest.h>

#include <limits>

namespace {

using namespace voxel_test;

/** More points than one batch, those of a voxel far apart in the order; some are not
 * finite. */
std::vector<Eigen::Vector3f>
manyPoints()
{
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 1100000; ++i)
    points.emplace_back(0.01f + 0.05f * static_cast<float>(i % 31),
                        0.01f + 0.05f * static_cast<float>(i % 7), 0.01f);
  for (const std::size_t i : {std::size_t{0}, std::size_t{500000}, points.size() - 1})
    points[i].y() = std::numeric_limits<float>::quiet_NaN();
  return points;
}

/** Returns the points that are visited for each voxel. */
std::vector<std::vector<std::size_t>>
visited(const std::vector<Eigen::Vector3f>& points,
        const std::vector<VoxelSum>& voxels,
        const pcl::Indices* indices,
        unsigned threads)
{
  const VoxelIndex index(VoxelFrame(Eigen::Array3f::Constant(20)), voxels);
  std::vector<std::vector<std::size_t>> seen(voxels.size());
  visitVoxels(index, viewOf(points), indices, threads,
              [&](std::size_t voxel, std::size_t i) { seen[voxel].push_back(i); });
  return seen;
}

TEST(VisitVoxels, EveryPointIsSeenOnceByItsVoxelInItsOrderForAnyThreads)
{
  const std::vector<Eigen::Vector3f> points = manyPoints();
  const std::vector<VoxelSum> voxels = sumsOf(points);
  ASSERT_EQ(voxels.size(), 31u * 7);
  for (const unsigned threads : {1u, 3u, 8u}) {
    const auto seen = visited(points, voxels, nullptr, threads);
    std::size_t all = 0;
    for (std::size_t v = 0; v < voxels.size(); ++v) {
      ASSERT_EQ(seen[v].size(), voxels[v].count);
      ASSERT_TRUE(std::is_sorted(seen[v].begin(), seen[v].end()));
      for (const std::size_t i : seen[v])
        ASSERT_TRUE(points[i].allFinite() && i % (31 * 7) == seen[v][0] % (31 * 7));
      all += seen[v].size();
    }
    EXPECT_EQ(all, points.size() - 3);
  }
}

TEST(VisitVoxels, PointsThatDoNotCountOrLieInNoVoxelAreNotSeen)
{
  const std::vector<Eigen::Vector3f> points{{0.01f, 0, 0},
                                            {0.06f, 0, 0},
                                            {0.02f, 0, 0},
                                            {9, 0, 0},
                                            {0.03f, 0, 0}};
  const std::vector<VoxelSum> voxels = sumsOf({points[0], points[1]});
  const pcl::Indices indices{4, 3, 1, 0};
  const auto seen = visited(points, voxels, &indices, 2);
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_EQ(seen[0], (std::vector<std::size_t>{4, 0})) << "in the order of the indices";
  EXPECT_EQ(seen[1], (std::vector<std::size_t>{1}));
  EXPECT_TRUE(visited({}, {}, nullptr, 2).empty());
}

} // namespace

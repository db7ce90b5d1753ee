// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/stage_error.h>

#include <gtest/gtest.h>

#include <memory>
#include <utility>

using pcl::sedr::StageIndices;

namespace {

/** Returns the argument as a setter sees it. */
pcl::shared_ptr<const pcl::Indices>
seenOf(const StageIndices& indices)
{
  return indices.get();
}

} // namespace

TEST(StageIndices, PointersAreSharedWhateverTheyPointTo)
{
  const auto indices = pcl::make_shared<pcl::Indices>(pcl::Indices{1, 2, 3});
  const pcl::shared_ptr<const pcl::Indices> constant = indices;
  EXPECT_EQ(seenOf(indices), indices);
  EXPECT_EQ(seenOf(constant), indices);

  const auto points = pcl::make_shared<pcl::PointIndices>();
  points->indices = {4, 5};
  const pcl::PointIndices::ConstPtr constant_points = points;
  EXPECT_EQ(seenOf(points).get(), &points->indices);
  EXPECT_EQ(seenOf(constant_points).get(), &points->indices);
}

TEST(StageIndices, ASharedPointerOutlivesThePointIndicesItCameFrom)
{
  auto points = pcl::make_shared<pcl::PointIndices>();
  points->indices = {4, 5};
  const auto seen = seenOf(points);
  points.reset();
  EXPECT_EQ(*seen, (pcl::Indices{4, 5}));
}

TEST(StageIndices, ValuesAreTakenAsTheyAre)
{
  pcl::PointIndices points;
  points.indices = {7, 8, 9};
  EXPECT_EQ(*seenOf(points), points.indices);
  EXPECT_EQ(*seenOf(points.indices), points.indices);
  EXPECT_EQ(*seenOf(pcl::Indices{6}), pcl::Indices{6});
}

TEST(StageIndices, NullOfAnyKindIsNone)
{
  EXPECT_EQ(seenOf(nullptr), nullptr);
  EXPECT_EQ(seenOf(pcl::shared_ptr<pcl::Indices>()), nullptr);
  EXPECT_EQ(seenOf(pcl::shared_ptr<const pcl::Indices>()), nullptr);
  EXPECT_EQ(seenOf(pcl::PointIndices::Ptr()), nullptr);
  EXPECT_EQ(seenOf(pcl::PointIndices::ConstPtr()), nullptr);
}

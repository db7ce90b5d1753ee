// SPDX-License-Identifier: BSD-3-Clause
#include "storey_band.h"

#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <limits>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** Points at the heights -2.5 m (a mirror image), 0 m, 1 m, 2.5 m, 4 m and one that is
 * not finite. */
Cloud::Ptr
column()
{
  Cloud::Ptr cloud(new Cloud);
  for (const float z : {-2.5f, 0.f, 1.f, 2.5f, 4.f})
    cloud->push_back({0, 0, z});
  cloud->push_back({0, 0, std::numeric_limits<float>::quiet_NaN()});
  cloud->is_dense = false;
  return cloud;
}

TEST(StoreyBand, KeepsWhatLiesBetweenFloorAndCeiling)
{
  StoreyBand<pcl::PointXYZ> band(true);
  band.setInputCloud(column());
  band.setHeights(0, 2.5);
  pcl::Indices kept;
  band.filter(kept);
  EXPECT_EQ(kept, (pcl::Indices{1, 2, 3}));
  EXPECT_EQ(*band.getRemovedIndices(), (pcl::Indices{0, 4, 5}));
  EXPECT_EQ(band.getErrorMessage(), "");

  band.setNegative(true);
  band.filter(kept);
  EXPECT_EQ(kept, (pcl::Indices{0, 4})); // the point that is not finite is never kept
}

TEST(StoreyBand, RefusesAStoreyWithoutHeight)
{
  StoreyBand<pcl::PointXYZ> band(true);
  band.setInputCloud(column());
  band.setHeights(2.5, 0);
  pcl::Indices kept;
  band.filter(kept);
  EXPECT_TRUE(kept.empty());
  EXPECT_EQ(band.getRemovedIndices()->size(), 6u);
  EXPECT_NE(band.getErrorMessage().find("2.5"), std::string::npos);
}

} // namespace

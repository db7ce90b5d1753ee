// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_test.h"

#include "sedr_filters/src/voxels/voxel_sums.h"

#include <pcl/sedr_filters/voxel_grid_settings.h>

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace {

using namespace pcl::sedr;
using Eigen::Vector3f;
using Eigen::Vector3i;

/** The settings without a filter. */
struct Settings : VoxelGridSettings {
  using VoxelGridSettings::clearLayout;
  using VoxelGridSettings::parameterProblem;
  using VoxelGridSettings::passesLimits;

  std::size_t thin(const std::vector<Vector3f>& points)
  {
    VoxelSums sums(inverseLeaf());
    sums.add(voxel_test::viewOf(points), 1);
    return finish(sums);
  }
};

/** Voxels of 1 m at (0, 0, 0) with two points, (2, 0, 0) and (0, 1, 3). */
std::vector<Vector3f>
threeVoxels()
{
  return {{0.2f, 0.5f, 0.5f}, {2.5f, 0.5f, 0.5f}, {0.5f, 1.5f, 3.5f}, {0.4f, 0.1f, 0}};
}

TEST(VoxelGridSettings, LeavesMustBeAboveZeroAndFinite)
{
  Settings settings;
  EXPECT_EQ(settings.getLeafSize(), Vector3f::Constant(0.05f));
  EXPECT_EQ(settings.parameterProblem(), "");
  constexpr float infinite = std::numeric_limits<float>::infinity();
  constexpr float tiny = std::numeric_limits<float>::denorm_min();
  for (const float wrong : {0.f, -1.f, infinite, -infinite, tiny,
                            std::numeric_limits<float>::quiet_NaN()}) {
    settings.setLeafSize(0.1f, 0.2f, wrong);
    EXPECT_NE(settings.parameterProblem(), "") << wrong;
  }
  settings.setLeafSize(0.1f, -0.5f, 0.2f);
  EXPECT_EQ(settings.parameterProblem(), "the leaf must be above 0 m along x, y and z, "
                                         "it is 0.1 x -0.5 x 0.2 m");
  settings.setLeafSize({1, 2, 3, -7});
  EXPECT_EQ(settings.parameterProblem(), "") << "the fourth value is ignored";
  EXPECT_EQ(settings.getLeafSize(), Vector3f(1, 2, 3));
}

TEST(VoxelGridSettings, LimitsAreIncludedAndNotANumberIsNeitherInsideNorOutside)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Settings settings;
  EXPECT_TRUE(settings.passesLimits(1e30));
  settings.setFilterLimits(1, 2);
  for (const bool outside : {false, true}) {
    settings.setFilterLimitsNegative(outside);
    EXPECT_EQ(settings.passesLimits(0.9), outside);
    EXPECT_TRUE(settings.passesLimits(1));
    EXPECT_EQ(settings.passesLimits(1.5), !outside);
    EXPECT_TRUE(settings.passesLimits(2));
    EXPECT_EQ(settings.passesLimits(2.1), outside);
    EXPECT_FALSE(settings.passesLimits(nan));
  }
}

TEST(VoxelGridSettings, TheLayoutTellsWhichVoxelBecameWhichPoint)
{
  Settings settings;
  settings.setLeafSize(1, 1, 1);
  settings.setSaveLeafLayout(true);
  ASSERT_EQ(settings.thin(threeVoxels()), 3u);
  EXPECT_EQ(settings.getMinBoxCoordinates(), Vector3i(0, 0, 0));
  EXPECT_EQ(settings.getMaxBoxCoordinates(), Vector3i(2, 1, 3));
  EXPECT_EQ(settings.getNrDivisions(), Vector3i(3, 2, 4));
  EXPECT_EQ(settings.getDivisionMultiplier(), Vector3i(1, 3, 6));
  EXPECT_EQ(settings.getCentroidIndexAt({0, 0, 0}), 0);
  EXPECT_EQ(settings.getCentroidIndexAt({2, 0, 0}), 1);
  EXPECT_EQ(settings.getCentroidIndexAt({0, 1, 3}), 2);
  EXPECT_EQ(settings.getCentroidIndexAt({1, 0, 0}), -1) << "empty";
  EXPECT_EQ(settings.getCentroidIndexAt({0, 1, 4}), -1) << "outside";
  std::vector<int> layout(3 * 2 * 4, -1);
  layout[0] = 0;
  layout[2] = 1;
  layout[0 + 1 * 3 + 3 * 6] = 2;
  EXPECT_EQ(settings.getLeafLayout(), layout);
  settings.clearLayout();
  EXPECT_EQ(settings.getCentroidIndexAt({0, 0, 0}), -1);
  EXPECT_TRUE(settings.getLeafLayout().empty());
  EXPECT_EQ(settings.getMaxBoxCoordinates(), Vector3i(0, 0, 0));
}

TEST(VoxelGridSettings, VoxelsOfTooFewPointsGiveNone)
{
  Settings settings;
  settings.setLeafSize(1, 1, 1);
  settings.setSaveLeafLayout(true);
  settings.setMinimumPointsNumberPerVoxel(2);
  ASSERT_EQ(settings.thin(threeVoxels()), 1u);
  EXPECT_EQ(settings.getCentroidIndexAt({0, 0, 0}), 0);
  EXPECT_EQ(settings.getCentroidIndexAt({2, 0, 0}), -1);
}

TEST(VoxelGridSettings, WithoutTheLayoutOnlyTheBoxIsKept)
{
  Settings settings;
  settings.setLeafSize(1, 1, 1);
  ASSERT_EQ(settings.thin(threeVoxels()), 3u);
  EXPECT_EQ(settings.getNrDivisions(), Vector3i(3, 2, 4));
  EXPECT_EQ(settings.getCentroidIndexAt({0, 0, 0}), -1);
  EXPECT_TRUE(settings.getLeafLayout().empty());
}

TEST(VoxelGridSettings, CoordinatesSaturate)
{
  constexpr int most = std::numeric_limits<int>::max();
  constexpr int least = std::numeric_limits<int>::min();
  Settings settings;
  EXPECT_EQ(settings.getGridCoordinates(-0.01f, 0.06f, 0), Vector3i(-1, 1, 0));
  EXPECT_EQ(settings.getGridCoordinates(1e20f, -1e20f, 0), Vector3i(most, least, 0));
  settings.thin({{1e20f, 0, 0}, {-1e20f, 0.06f, 0}});
  EXPECT_EQ(settings.getNrDivisions(), Vector3i(most, 2, 1));
  EXPECT_EQ(settings.getDivisionMultiplier(), Vector3i(1, most, most));
}

} // namespace

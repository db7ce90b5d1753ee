// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/refit/refit_sums.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace {

using namespace pcl::sedr;

/** Points of a patch about a mean distance, so many of them beyond the band. */
PatchSums
patchOf(double mean, int points, double beyond)
{
  constexpr double deviation = 0.015;
  PatchSums patch;
  for (int k = 0; k < points; ++k)
    patch.add(mean + (k % 2 == 0 ? deviation : -deviation), {1, 0, 0});
  patch.beyond = beyond;
  return patch;
}

PatchFit
fitOf(const std::vector<PatchSums>& patches, double beyond)
{
  return fitPatches(patches, std::vector<bool>(patches.size(), false), 1, 0.015,
                    beyond);
}

TEST(FitPatches, LeavesOutThoseThatGoOnBeyondTheBand)
{
  // They hold most of the points, and the nearest are in the noise of the others.
  std::vector<PatchSums> patches;
  for (int k = 0; k < 18; ++k)
    patches.push_back(patchOf(0, 60, 3));
  for (int k = 1; k <= 10; ++k)
    patches.push_back(patchOf(-0.001 * k, 160, 50));
  EXPECT_NEAR(fitOf(patches, 0.06).step[0], 0, 1e-9);
  EXPECT_EQ(fitOf(patches, 0.06).count, 18 * 60);
  EXPECT_LT(fitOf(patches, std::numeric_limits<double>::infinity()).step[0], -0.0005);
}

TEST(FitPatches, KeepsThemWhereAllGoOn)
{
  // The noise of a far denser surface reaches there, here more and there less.
  std::vector<PatchSums> patches;
  for (int k = 0; k < 100; ++k)
    patches.push_back(patchOf(0, 10, 1 + k % 6));
  EXPECT_EQ(fitOf(patches, 0.06).count, 1000);
}

TEST(FitPatches, KeepsThemWhereChanceExplainsIt)
{
  std::vector<PatchSums> patches;
  for (int k = 0; k < 100; ++k)
    patches.push_back(patchOf(0, 10, k % 3));
  EXPECT_EQ(fitOf(patches, 0.02).count, 1000);
}

} // namespace

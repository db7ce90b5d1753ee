// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include "sedr_filters/src/base/plane_fit.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <random>
#include <set>

namespace {

using namespace pcl::sedr;
using sedr_test::slabAt;

struct Points {
  std::vector<Eigen::Vector3f> points;

  /** A lattice of 5 cm over [x0, x0 + width] x [0, 3], `offset` above a plane. */
  void add(const PlanSlab& plane, double x0, double width, double offset = 0)
  {
    for (double x = x0 + 0.025; x < x0 + width; x += 0.05)
      for (double y = 0.025; y < 3; y += 0.05)
        points.emplace_back(static_cast<float>(x), static_cast<float>(y),
                            static_cast<float>(plane.heightAt({x, y}) + offset));
  }

  PointView view() const
  {
    return points.empty()
               ? PointView()
               : PointView(points[0].data(), sizeof points[0], points.size());
  }

  std::vector<int> all() const
  {
    std::vector<int> indices(points.size());
    std::iota(indices.begin(), indices.end(), 0);
    return indices;
  }
};

double
degreesBetween(const PlanSlab& a, const PlanSlab& b)
{
  const Eigen::Vector3d n = a.plane.head<3>();
  const Eigen::Vector3d m = b.plane.head<3>();
  return std::atan2(n.cross(m).norm(), n.dot(m)) * 180 / M_PI;
}

TEST(FitSlab, FindsAnExactPlane)
{
  for (const double slope : {0.0, 0.01, -0.3}) {
    const PlanSlab truth = slabAt(2.4, slope, -slope / 2);
    Points cloud;
    cloud.add(truth, -2, 5);
    const PlanSlab slab = fitSlab(cloud.view(), cloud.all());
    EXPECT_LT(degreesBetween(slab, truth), 1e-4);
    EXPECT_NEAR(slab.plane.head<3>().norm(), 1, 1e-12);
    EXPECT_NEAR(slab.heightAt({1, 1}), truth.heightAt({1, 1}), 1e-6);
    EXPECT_EQ(slab.inliers, cloud.points.size());
    EXPECT_NEAR(slab.residual, 0, 1e-6);
  }
}

TEST(FitSlab, IsTheLeastSquaresMiddleOfTwoSheetsWithTheirResidual)
{
  const PlanSlab truth = slabAt(2.4, 0.05);
  const double c = truth.plane[2]; // a sheet shifted in z by h is h * c away
  Points cloud;
  cloud.add(truth, 0, 4, 0.02 / c);
  cloud.add(truth, 0, 4, -0.02 / c);
  const PlanSlab slab = fitSlab(cloud.view(), cloud.all());
  EXPECT_LT(degreesBetween(slab, truth), 1e-3);
  EXPECT_NEAR(slab.heightAt({2, 1}), truth.heightAt({2, 1}), 1e-5);
  EXPECT_NEAR(slab.residual, 0.02, 1e-6);
}

TEST(FitSlab, LooksAtTheIndexedPointsOnly)
{
  Points cloud;
  cloud.add(slabAt(0), 0, 2);
  const auto ground = static_cast<int>(cloud.points.size());
  cloud.add(slabAt(2.5), 0, 2);
  std::vector<int> upper = cloud.all();
  upper.erase(upper.begin(), upper.begin() + ground);
  EXPECT_NEAR(fitSlab(cloud.view(), upper).heightAt({1, 1}), 2.5, 1e-6);
}

TEST(FitSlab, TooFewPointsGiveTheHorizontalPlaneThroughTheirMean)
{
  Points cloud;
  EXPECT_TRUE(fitSlab(cloud.view(), {}).plane.isApprox(Eigen::Vector4d(0, 0, 1, 0)));
  EXPECT_EQ(fitSlab(cloud.view(), {}).inliers, 0u);
  cloud.points = {{0, 0, 1}, {4, 0, 2}};
  EXPECT_TRUE(
      fitSlab(cloud.view(), {0, 1}).plane.isApprox(Eigen::Vector4d(0, 0, 1, -1.5)));
  EXPECT_NEAR(fitSlab(cloud.view(), {0, 1}).residual, 0.5, 1e-6);
}

TEST(FitSlab, PointsOnALineOrAWallGiveTheHorizontalPlaneThroughTheirMean)
{
  Points line;
  for (int i = 0; i <= 10; ++i)
    line.points.emplace_back(0.1f * static_cast<float>(i), 2.f,
                             0.05f * static_cast<float>(i));
  EXPECT_TRUE(fitSlab(line.view(), line.all())
                  .plane.isApprox(Eigen::Vector4d(0, 0, 1, -0.25), 1e-6));
  Points wall;
  for (int i = 0; i <= 10; ++i)
    for (int k = 0; k <= 10; ++k)
      wall.points.emplace_back(0.1f * static_cast<float>(i), 2.f,
                               0.1f * static_cast<float>(k));
  EXPECT_TRUE(fitSlab(wall.view(), wall.all())
                  .plane.isApprox(Eigen::Vector4d(0, 0, 1, -0.5), 1e-6));
}

TEST(FitSlabRobustly, IsNotPulledByWhatHangsBelow)
{
  const PlanSlab truth = slabAt(2.4, 0.01, 0.005);
  Points cloud;
  cloud.add(truth, 0, 4);
  cloud.add(truth, 0, 0.5, -0.045); // cladding 4.5 cm lower along one wall
  const PlanSlab pulled = fitSlab(cloud.view(), cloud.all());
  EXPECT_GT(degreesBetween(pulled, truth), 0.1) << "else this test shows nothing";
  const PlanSlab slab = fitSlabRobustly(cloud.view(), cloud.all(), slabAt(2.42), 0.07);
  EXPECT_LT(degreesBetween(slab, truth), 1e-3);
  EXPECT_NEAR(slab.heightAt({2, 1}), truth.heightAt({2, 1}), 1e-5);
  EXPECT_EQ(slab.inliers, 80u * 60u);
}

TEST(FitSlabRobustly, LeavesTheStartWhereItHoldsNothing)
{
  Points cloud;
  cloud.add(slabAt(2.4), 0, 4);
  const PlanSlab start = slabAt(1);
  EXPECT_EQ(fitSlabRobustly(cloud.view(), cloud.all(), start, 0.07).plane, start.plane);
}

TEST(FitParallel, KeepsTheDirectionAndFindsTheHeight)
{
  const PlanSlab direction = slabAt(5, 0.02, 0.01);
  Points cloud;
  cloud.add(slabAt(2.4, 0.02, 0.01), 0, 4);
  cloud.add(slabAt(2.4, 0.02, 0.01), 0, 0.5, -0.045);
  const PlanSlab slab =
      fitParallel(cloud.view(), cloud.all(), direction, slabAt(2.43), 0.07);
  EXPECT_EQ(slab.plane.head<3>(), direction.plane.head<3>());
  EXPECT_NEAR(slab.heightAt({0, 0}), 2.4, 1e-5);
  EXPECT_EQ(slab.inliers, 80u * 60u);
  EXPECT_NEAR(slab.residual, 0, 1e-5);
}

TEST(FitParallel, StartsFromATiltedPlaneAmongThePointsHoweverFarTheOrigin)
{
  Points cloud;
  cloud.add(slabAt(2.4), 50, 0.5);
  // Tilted by two degrees, through the middle of the points.
  const double slope = std::tan(2 * M_PI / 180);
  const PlanSlab start = slabAt(2.4 - slope * 50.25, slope, 0);
  const PlanSlab slab = fitParallel(cloud.view(), cloud.all(), slabAt(0), start, 0.05);
  EXPECT_NEAR(slab.heightAt({50, 1}), 2.4, 1e-5);
  EXPECT_EQ(slab.inliers, cloud.points.size());
}

TEST(FitParallel, OfAPlaneTiltedOtherwiseHasItsDeviationForResidual)
{
  // Over 4 m it deviates by up to 2 cm each way, uniformly: 4 cm / sqrt(12).
  Points cloud;
  cloud.add(slabAt(2.4, 0.01), 0, 4);
  const PlanSlab slab =
      fitParallel(cloud.view(), cloud.all(), slabAt(0), slabAt(2.42), 0.07);
  EXPECT_NEAR(slab.heightAt({0, 0}), 2.42, 1e-4);
  EXPECT_NEAR(slab.residual, 0.04 / std::sqrt(12), 1e-4);
}

TEST(FindSlab, FindsTheLargerOfTwoPlanesAmongClutter)
{
  const PlanSlab truth = slabAt(2.4, 0.015, -0.01);
  Points cloud;
  cloud.add(truth, 0, 4);
  cloud.add(slabAt(2.1), 0, 2);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> in_room(0, 3);
  for (int i = 0; i < 4000; ++i)
    cloud.points.emplace_back(in_room(random), in_room(random), in_room(random));
  const PlanSlab slab = findSlab(cloud.view(), cloud.all(), 0.05, 0.05, 1);
  EXPECT_LT(degreesBetween(slab, truth), 0.02);
  EXPECT_NEAR(slab.heightAt({2, 1.5}), truth.heightAt({2, 1.5}), 0.0005);
}

TEST(FindSlab, IsTiltedNoMoreThanAllowed)
{
  for (const double tilt : {2.0, 4.0, 10.0}) {
    Points cloud;
    cloud.add(slabAt(2.4, std::tan(tilt * M_PI / 180)), 0, 4);
    const double limit = 3 * M_PI / 180;
    const PlanSlab slab = findSlab(cloud.view(), cloud.all(), 0.05, limit, 1);
    const double found = degreesBetween(slab, slabAt(0));
    EXPECT_LE(found, 3 + 1e-6) << tilt;
    if (tilt < 3) {
      EXPECT_NEAR(found, tilt, 1e-3);
    }
  }
}

TEST(FindSlab, ALargerRampDoesNotHideAPlaneThatIsTiltedLittle)
{
  const PlanSlab truth = slabAt(2.4, std::tan(2 * M_PI / 180));
  Points cloud;
  cloud.add(truth, 0, 2);
  cloud.add(slabAt(1.2, std::tan(10 * M_PI / 180)), 0, 6);
  const PlanSlab slab = findSlab(cloud.view(), cloud.all(), 0.02, 3 * M_PI / 180, 1);
  EXPECT_LT(degreesBetween(slab, truth), 0.01);
  EXPECT_NEAR(slab.heightAt({1, 1}), truth.heightAt({1, 1}), 1e-4);
}

TEST(FindSlab, OfClutterIsAMatterOfTheSeedAlone)
{
  Points cloud;
  std::mt19937 random(5);
  std::uniform_real_distribution<float> place(0, 3);
  std::uniform_real_distribution<float> height(2.2f, 2.5f);
  for (int i = 0; i < 600; ++i)
    cloud.points.emplace_back(place(random), place(random), height(random));
  std::set<double> offsets;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const PlanSlab slab = findSlab(cloud.view(), cloud.all(), 0.02, 0.05, seed);
    offsets.insert(slab.plane[3]);
    EXPECT_EQ(findSlab(cloud.view(), cloud.all(), 0.02, 0.05, seed).plane, slab.plane);
  }
  EXPECT_GT(offsets.size(), 1u) << "else this shows nothing";
}

TEST(FindSlab, IsTheSameForASeedAndNearlyTheSameForAll)
{
  const PlanSlab truth = slabAt(2.4, 0.01);
  Points cloud;
  cloud.add(truth, 0, 4);
  std::mt19937 random(3);
  std::normal_distribution<float> noise(0, 0.01f);
  for (auto& p : cloud.points)
    p.z() += noise(random);
  const PlanSlab first = findSlab(cloud.view(), cloud.all(), 0.05, 0.05, 7);
  for (const unsigned threads : {1u, 2u, 5u})
    EXPECT_EQ(findSlab(cloud.view(), cloud.all(), 0.05, 0.05, 7, threads).plane,
              first.plane);
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const PlanSlab slab = findSlab(cloud.view(), cloud.all(), 0.05, 0.05, seed);
    EXPECT_LT(degreesBetween(slab, truth), 0.05) << seed;
    EXPECT_NEAR(slab.residual, 0.01, 0.001) << seed;
  }
}

TEST(FindLargerSlab, OfTwoFloorsAStepApartIsTheLargerNotOneAcrossBoth)
{
  for (const double step : {0.05, 0.08, 0.1}) {
    Points cloud;
    cloud.add(slabAt(0), 0, 4.5);
    cloud.add(slabAt(step), 4.5, 3.5);
    const PlanSlab across = findSlab(cloud.view(), cloud.all(), 0.07, 0.05, 1);
    EXPECT_GT(across.residual, 0.01) << "there would be nothing to do";
    const PlanSlab slab = findLargerSlab(cloud.view(), cloud.all(), 0.07, 0.05, 1);
    EXPECT_NEAR(slab.heightAt({0, 0}), 0, 1e-4) << step;
    EXPECT_NEAR(slab.heightAt({8, 3}), 0, 1e-4) << step;
  }
}

TEST(FindLargerSlab, TailsOfNoiseAboveASurfaceAreNoSecondOne)
{
  // As voxels sample it: the surface, and layers above and below it.
  Points cloud;
  cloud.add(slabAt(2.5), 0, 6);
  cloud.add(slabAt(2.46), 0, 4);
  const PlanSlab slab = findLargerSlab(cloud.view(), cloud.all(), 0.05, 0.05, 1);
  EXPECT_EQ(slab.plane, findSlab(cloud.view(), cloud.all(), 0.05, 0.05, 1).plane);
}

TEST(FindLargerSlab, IsTheSameAsFindSlabWhereThereAreNoTwoParallelPlanes)
{
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.02);
  Points noisy;
  noisy.add(slabAt(2.5, 0.01, 0), 0, 4);
  for (auto& p : noisy.points)
    p.z() += static_cast<float>(noise(random));
  Points wave; // 3 cm up and down over 6 m
  wave.add(slabAt(2.5), 0, 6);
  for (auto& p : wave.points)
    p.z() += 0.03F * std::sin(p.x() * static_cast<float>(M_PI) / 3);
  for (const Points* cloud : {&noisy, &wave}) {
    const PlanSlab larger = findLargerSlab(cloud->view(), cloud->all(), 0.07, 0.05, 1);
    const PlanSlab one = findSlab(cloud->view(), cloud->all(), 0.07, 0.05, 1);
    EXPECT_EQ(larger.plane, one.plane);
  }
}

TEST(FindSlab, OfHardlyAnythingIsHorizontal)
{
  Points cloud;
  EXPECT_EQ(findSlab(cloud.view(), {}, 0.05, 0.05, 1).plane, slabAt(0).plane);
  cloud.points = {{1, 1, 2.5f}};
  EXPECT_EQ(findSlab(cloud.view(), {0}, 0.05, 0.05, 1).plane, slabAt(2.5).plane);
  cloud.points.assign(50, {1, 1, 2.5f});
  EXPECT_EQ(findSlab(cloud.view(), cloud.all(), 0.05, 0.05, 1).plane,
            slabAt(2.5).plane);
}

} // namespace

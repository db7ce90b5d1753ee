// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include "sedr_filters/src/base/plane_fit.h"

#include <gtest/gtest.h>

#include <limits>
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
};

double
degreesBetween(const PlanSlab& a, const PlanSlab& b)
{
  const Eigen::Vector3d n = a.plane.head<3>();
  const Eigen::Vector3d m = b.plane.head<3>();
  return std::atan2(n.cross(m).norm(), n.dot(m)) * 180 / M_PI;
}

TEST(FitSlabRobustly, FindsAnExactPlane)
{
  for (const double slope : {0.0, 0.01, -0.3}) {
    const PlanSlab truth = slabAt(2.4, slope, -slope / 2);
    Points cloud;
    cloud.add(truth, -2, 5);
    const PlanSlab slab = fitSlabRobustly(cloud.points, slabAt(2.4), 3);
    EXPECT_LT(degreesBetween(slab, truth), 1e-4);
    EXPECT_NEAR(slab.plane.head<3>().norm(), 1, 1e-12);
    EXPECT_NEAR(slab.heightAt({1, 1}), truth.heightAt({1, 1}), 1e-6);
    EXPECT_EQ(slab.inliers, cloud.points.size());
    EXPECT_NEAR(slab.residual, 0, 1e-6);
  }
}

TEST(FitSlabRobustly, IsNotPulledByWhatHangsBelow)
{
  const PlanSlab truth = slabAt(2.4, 0.01, 0.005);
  Points cloud;
  cloud.add(truth, 0, 4);
  cloud.add(truth, 0, 0.5, -0.045); // cladding 4.5 cm lower along one wall
  const PlanSlab slab = fitSlabRobustly(cloud.points, slabAt(2.42), 0.07);
  EXPECT_LT(degreesBetween(slab, truth), 1e-3);
  EXPECT_NEAR(slab.heightAt({2, 1}), truth.heightAt({2, 1}), 1e-5);
  EXPECT_EQ(slab.inliers, 80u * 60u);
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
  const PlanSlab slab = findSlab(cloud.points, 0.05, 0.05, 1);
  EXPECT_LT(degreesBetween(slab, truth), 0.02);
  EXPECT_NEAR(slab.heightAt({2, 1.5}), truth.heightAt({2, 1.5}), 0.0005);
}

TEST(FindSlab, IsTiltedNoMoreThanAllowed)
{
  for (const double tilt : {2.0, 4.0, 10.0}) {
    Points cloud;
    cloud.add(slabAt(2.4, std::tan(tilt * M_PI / 180)), 0, 4);
    const double limit = 3 * M_PI / 180;
    const PlanSlab slab = findSlab(cloud.points, 0.05, limit, 1);
    const double found = degreesBetween(slab, slabAt(0));
    EXPECT_LE(found, 3 + 1e-6) << tilt;
    if (tilt < 3) {
      EXPECT_NEAR(found, tilt, 1e-3);
    }
  }
}

} // namespace

// SPDX-License-Identifier: BSD-3-Clause
#include "results/distance_colour.h"
#include "results/surface_finder.h"
#include "tools/pictures/pictures.h"

namespace {

using namespace programs;
using namespace pcl::sedr;

TEST(SurfaceFinder, FindsPlanesEdgesAndCorners)
{
  const Eigen::Vector3d a(0, 0, 0);
  const Eigen::Vector3d b(2, 0, 0);
  const Eigen::Vector3d c(0, 2, 0);
  const auto nearest = [&](double x, double y, double z) {
    return nearestOnTriangle({x, y, z}, a, b, c);
  };
  EXPECT_TRUE(nearest(0.5, 0.5, 3).isApprox(Eigen::Vector3d(0.5, 0.5, 0)));
  EXPECT_TRUE(nearest(1, -1, 1).isApprox(Eigen::Vector3d(1, 0, 0)));
  EXPECT_TRUE(nearest(2, 2, 0).isApprox(Eigen::Vector3d(1, 1, 0)));
  EXPECT_TRUE(nearest(5, -1, 1).isApprox(b));
  EXPECT_TRUE(nearestOnTriangle({1, 1, 0}, a, b, b).isApprox(Eigen::Vector3d(1, 0, 0)))
      << "a triangle without area";
  EXPECT_FALSE(nearestTriangle({}, a).isFound());
}

TEST(DistanceColour, RunsFromBlueToRedAndStaysThere)
{
  EXPECT_GT(distanceColour(0, 0.05).blue, 150);
  EXPECT_GT(distanceColour(0.05, 0.05).red, 150);
  EXPECT_EQ(distanceColour(0.05, 0.05), distanceColour(7, 0.05));
  EXPECT_EQ(distanceColour(std::nan(""), 0.05), colours::other);
  EXPECT_EQ(distanceText(0.05), "5 cm");
  EXPECT_EQ(distanceText(0.0034), "0.3 cm");
}

} // namespace

// SPDX-License-Identifier: BSD-3-Clause
#include "results/distance_colour.h"
#include "tools/pictures/pictures.h"

namespace {

using namespace programs;
using namespace pcl::sedr;

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

// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include <pcl/sedr_filters/straightening.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

constexpr double degree = M_PI / 180;

TEST(Straightening, BringsWallsToTheirHeadsAndBack)
{
  // Corners of various angles; two walls that do not meet are tilted.
  constexpr double tolerance = 1e-9;
  Floorplan plan{{roomOf(polygon({{0, 0}, {6, 0}, {7, 4}, {3, 6}, {0, 4}}), 2.6)}};
  plan.rooms[0].boundary.elements[1].tilt = 12 * degree;
  plan.rooms[0].boundary.elements[4].tilt = 5 * degree;
  const Floorplan straight = straightened(plan);
  EXPECT_FALSE(isTilted(straight.rooms[0]));
  const Straightening map(tiltedFaces(plan));
  const PlanLoop& top = straight.rooms[0].boundary;
  for (double z = 0.0; z <= 2.6; z += 0.2) {
    const PlanLoop section = boundaryAt(plan.rooms[0], z);
    for (std::size_t i = 0; i < section.elements.size(); ++i)
      for (const double share : {0.02, 0.3, 0.7, 0.98}) {
        const PlanElement& wall = section.elements[i];
        Eigen::Vector3d p;
        p << wall.pointAt(share * wall.length()), z;
        const Eigen::Vector3d q = map.straighten(p);
        EXPECT_NEAR(top.elements[i].distance(q.head<2>()), 0, tolerance)
            << i << ' ' << z << ' ' << share;
        EXPECT_NEAR((map.back(q) - p).norm(), 0, 1e-9) << i << ' ' << z;
        EXPECT_EQ(q.z(), z);
      }
  }
}

TEST(Straightening, TurnsNormalsWithTheWalls)
{
  Floorplan plan{{roomOf(rectangle(0, 0, 6, 4), 2.5)}};
  plan.rooms[0].boundary.elements[1].tilt = 12 * degree;
  const Straightening map(tiltedFaces(plan));
  const double head = 6 - 2.5 * std::tan(12 * degree);
  const Eigen::Vector3d normal = map.normalBack({head, 2, 1}, {-1, 0, 0});
  EXPECT_NEAR(normal.x(), -std::cos(12 * degree), 1e-9);
  EXPECT_NEAR(normal.z(), -std::sin(12 * degree), 1e-9);
  EXPECT_NEAR(map.normalBack({3, 2, 0}, {0, 0, 1}).z(), 1, 1e-9);
}

TEST(Straightening, AWallBetweenTwoRoomsIsTiltedWithBothItsFaces)
{
  PlanRoom east = roomOf(rectangle(4.1, 0, 8, 4), 2.5, 2);
  Floorplan plan{{roomOf(rectangle(0, 0, 4, 4), 2.5, 1), east}};
  plan.rooms[0].boundary.elements[1].tilt = 8 * degree;
  plan.rooms[1].boundary.elements[3].tilt = -8 * degree;
  const Straightening map(tiltedFaces(plan));
  const double shift = 2.5 * std::tan(8 * degree);
  EXPECT_NEAR(map.straighten({4, 2, 0}).x(), 4 - shift, 1e-9);
  EXPECT_NEAR(map.straighten({4.1, 2, 0}).x(), 4.1 - shift, 1e-9);
  EXPECT_NEAR(map.straighten({4.05, 2, 0}).x(), 4.05 - shift, 1e-9);
  EXPECT_NEAR(map.back({4.05 - shift, 2, 0}).x(), 4.05, 1e-9);
  EXPECT_NEAR(map.straighten({8, 2, 0}).x(), 8, 1e-9) << "walls parallel to it stay";
}

} // namespace

// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include "sedr_segmentation/src/plan/short_elements.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

PlanLoop
loopThrough(const std::vector<Eigen::Vector2d>& corners)
{
  PlanLoop loop;
  for (std::size_t k = 0; k < corners.size(); ++k)
    loop.elements.push_back(segment(corners[k], corners[(k + 1) % corners.size()]));
  return loop;
}

std::size_t
elementsLeft(const std::vector<Eigen::Vector2d>& corners, PlanLoop& loop)
{
  Floorplan plan{{roomOf(loopThrough(corners), 3)}};
  removeShortElements(plan, {});
  loop = plan.rooms[0].boundary;
  return loop.elements.size();
}

TEST(ShortElements, GoWhereTheirNeighboursMeet)
{
  PlanLoop loop;
  ASSERT_EQ(elementsLeft({{0, 0}, {4, 0}, {4, 2.992}, {3.995, 3}, {0, 3}}, loop), 4u);
  EXPECT_NEAR((loop.elements[1].end - Eigen::Vector2d(4, 3)).norm(), 0, 1e-9);
  EXPECT_NEAR(loop.area(), 12, 1e-9);
}

TEST(ShortElements, OfNoLengthGoBesideParallelWallsToo)
{
  PlanLoop loop;
  EXPECT_EQ(
      elementsLeft({{0, 0}, {2, 0}, {2, 0.0005}, {4, 0.0005}, {4, 3}, {0, 3}}, loop),
      5u);
}

TEST(ShortElements, StepsAndChamfersStay)
{
  PlanLoop loop;
  EXPECT_EQ(elementsLeft({{0, 0}, {2, 0}, {2, 0.01}, {4, 0.01}, {4, 3}, {0, 3}}, loop),
            6u)
      << "a step of 1 cm between parallel walls";
  EXPECT_EQ(elementsLeft({{0, 0}, {4, 0}, {4, 2.95}, {3.95, 3}, {0, 3}}, loop), 5u)
      << "a chamfer of 5 cm";
  EXPECT_EQ(elementsLeft({{0, 0}, {0.01, 0}, {0, 0.01}}, loop), 3u) << "a triangle";
}

} // namespace

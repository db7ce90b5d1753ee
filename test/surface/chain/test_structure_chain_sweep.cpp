// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include <pcl/sedr_surface/structure_chain.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(StructureChain, ARoomIsWholeThoughItsFarCeilingWasSeenInLinesOnly)
{
  RoomPoints points;
  const PlanLoop room = rectangle(0.01, 0.01, 10.01, 4.01);
  points.slab(room, 0);
  points.slab(room, 2.5,
              [](double x, double) { return x < 4 || std::fmod(x, 0.4) < 0.05; });
  for (const auto& wall : room.elements)
    points.wall(wall, 0, 2.5);
  StructureChain chain;
  ASSERT_TRUE(chain.findStructure(points.cloud())) << chain.problem;
  ASSERT_EQ(chain.plan->rooms.size(), 1u);
  EXPECT_NEAR(chain.plan->rooms[0].area(), 40, 0.1);
  EXPECT_EQ(chain.labels.size(), chain.cloud->size());
}

bool
tells(const StructureChain& chain, const char* words)
{
  return std::any_of(chain.warnings.begin(), chain.warnings.end(),
                     [&](const std::string& warning) {
                       return warning.find(words) != std::string::npos;
                     });
}

/** A corner of 12 m x 8 m is hidden from (3, 4) behind a pier at x = 6. */
TEST(StructureChain, AHiddenCornerIsOfTheRoomAndAWarningTellsHowMuchNobodySaw)
{
  const auto isSeen = [](double x, double y) {
    const double angle = std::atan2(y - 4, x - 3);
    return x < 6 || angle < 0.26 || angle > 0.58;
  };
  RoomPoints points;
  const PlanLoop room = rectangle(0.01, 0.01, 12.01, 8.01);
  for (const double z : {0.0, 3.0})
    points.slab(room, z, isSeen);
  for (const auto& wall : room.elements)
    points.wall(wall, 0, 3, [&](double s, double) {
      return isSeen(wall.pointAt(s).x(), wall.pointAt(s).y());
    });
  points.wall(segment({6.01, 4.8}, {6.01, 5.96}), 0, 3);
  StructureChain chain;
  ASSERT_TRUE(chain.findStructure(points.cloud())) << chain.problem;
  ASSERT_EQ(chain.plan->rooms.size(), 1u);
  const PlanLoop& boundary = chain.plan->rooms[0].boundary;
  EXPECT_EQ(boundary.elements.size(), 4u);
  EXPECT_NEAR(boundary.area(), 96, 0.3);
  EXPECT_TRUE(tells(chain, "m2 were not seen"));
}

/** A room of 6 m x 4 m x 2.5 m with a random point in every square of `spacing`. */
StructureChain::Cloud::Ptr
sparseRoom(double spacing, const RoomPoints::InSpace& keep)
{
  RoomPoints even(spacing);
  even.room(roomOf(rectangle(0.01, 0.01, 6.01, 4.01), 2.5), keep);
  auto cloud = even.cloud();
  std::mt19937 random(3);
  std::uniform_real_distribution<float> off(-0.5F, 0.5F);
  for (auto& p : *cloud)
    for (const int axis : {0, 1, 2}) { // along the surface, not off it
      const float low = axis == 2 ? 0.F : 0.01F;
      const float high = axis == 0 ? 6.01F : axis == 1 ? 4.01F : 2.5F;
      if (std::abs(p.data[axis] - low) > 0.01F && std::abs(p.data[axis] - high) > 0.01F)
        p.data[axis] += off(random) * static_cast<float>(spacing);
    }
  return cloud;
}

bool
tellsOfGuesses(const StructureChain& chain)
{
  return tells(chain, "filled in, not seen");
}

} // namespace

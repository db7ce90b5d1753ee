// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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
  ASSERT_TRUE(chain.findStructure(points.cloud())) << chain.getModel().problem;
  ASSERT_EQ(chain.getModel().plan->rooms.size(), 1u);
  EXPECT_NEAR(chain.getModel().plan->rooms[0].area(), 40, 0.1);
  EXPECT_EQ(chain.getModel().labels.size(), chain.getModel().cloud->size());
}

bool
tells(const StructureChain& chain, const char* words)
{
  return std::any_of(chain.getModel().warnings.begin(), chain.getModel().warnings.end(),
                     [&](const PlanWarning& warning) {
                       return sentenceOf(warning).find(words) != std::string::npos;
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
  ASSERT_TRUE(chain.findStructure(points.cloud())) << chain.getModel().problem;
  ASSERT_EQ(chain.getModel().plan->rooms.size(), 1u);
  const PlanLoop& boundary = chain.getModel().plan->rooms[0].boundary;
  EXPECT_EQ(boundary.elements.size(), 4u);
  EXPECT_NEAR(boundary.area(), 96, 0.3);
  EXPECT_TRUE(tells(chain, "m2 were not seen"));
}

} // namespace

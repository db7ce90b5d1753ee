// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include <pcl/sedr_surface/structure_chain.h>

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
  ASSERT_TRUE(chain.findStructure(points.cloud())) << chain.problem;
  ASSERT_EQ(chain.plan->rooms.size(), 1u);
  EXPECT_NEAR(chain.plan->rooms[0].area(), 40, 0.1);
  EXPECT_TRUE(std::any_of(chain.warnings.begin(), chain.warnings.end(),
                          [](const std::string& warning) {
                            return warning.find("sweep") != std::string::npos;
                          }));
  EXPECT_EQ(chain.labels.size(), chain.cloud->size());
}

} // namespace

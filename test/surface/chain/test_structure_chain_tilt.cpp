// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include <pcl/sedr_surface/mesh_distance.h>
#include <pcl/sedr_surface/structure_chain.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** Two rooms with a partition, turned by `degrees` about an oblique, distant axis. */
StructureChain::Cloud::Ptr
turnedFlat(double degrees)
{
  RoomPoints flat(0.05, 0.002);
  flat.room(rectangle(0, 0, 5, 4), 0, 2.5);
  flat.room(polygon({{5.1, 0}, {8, 0}, {8, 4}, {6, 4}, {6, 3}, {5.1, 3}}), 0, 2.5);
  const Eigen::AngleAxisd turn(degrees * M_PI / 180,
                               Eigen::Vector3d(0.8, 0.6, 0).normalized());
  auto cloud = flat.cloud();
  for (auto& p : *cloud)
    p.getVector3fMap() =
        (turn * (p.getVector3fMap().cast<double>() + Eigen::Vector3d(20, 7, 0)))
            .cast<float>();
  return cloud;
}

TEST(StructureChainTilt, ATiltedScanGivesThePlanOfTheLevelOne)
{
  StructureChain level;
  ASSERT_TRUE(level.findStructure(turnedFlat(0))) << level.problem;
  EXPECT_FALSE(level.levelling);
  EXPECT_TRUE(level.warnings.empty());
  for (const double degrees : {0.5, 1.0, 2.0, 2.9}) {
    SCOPED_TRACE(degrees);
    StructureChain chain;
    ASSERT_TRUE(chain.findStructure(turnedFlat(degrees))) << chain.problem;
    ASSERT_TRUE(chain.levelling);
    EXPECT_NEAR(chain.levelling->angle() * 180 / M_PI, degrees, 0.1);
    ASSERT_EQ(chain.warnings.size(), 1u);
    EXPECT_NE(chain.warnings[0].find("the scan is tilted by"), std::string::npos);
    ASSERT_EQ(chain.plan->rooms.size(), 2u);
    for (std::size_t r = 0; r < 2; ++r) {
      const PlanRoom& room = chain.plan->rooms[r];
      const PlanRoom& truth = level.plan->rooms[r];
      EXPECT_EQ(room.boundary.elements.size(), truth.boundary.elements.size());
      EXPECT_NEAR(room.area(), truth.area(), 0.02);
      EXPECT_NEAR(room.perimeter(), truth.perimeter(), 0.02);
      EXPECT_GT(room.floor.plane[2], std::cos(0.1 * M_PI / 180));
    }
  }
}

TEST(StructureChainTilt, WhatIsMadeOfItLiesOnTheScan)
{
  const auto scan = turnedFlat(2);
  StructureChain chain;
  ASSERT_TRUE(chain.findStructure(scan)) << chain.problem;
  std::vector<Eigen::Vector3d> points;
  for (const auto& p : *scan)
    points.push_back(p.getVector3fMap().cast<double>());
  const auto farthest = [&](const TriangleMesh& mesh) {
    return summarizeDistances(MeshDistance(mesh).distances(points)).max;
  };
  EXPECT_LT(farthest(chain.inScanFrame(chain.extrusion.getMesh())), 0.02);
  const auto structure = chain.structureInScanFrame();
  ASSERT_EQ(structure->size(), chain.structure->size());
  chain.keep_levelled = true;
  EXPECT_GT(farthest(chain.inScanFrame(chain.extrusion.getMesh())), 0.05);
  EXPECT_EQ(chain.structureInScanFrame(), chain.structure);
}

TEST(StructureChainTilt, WhatIsTrustedToBeLevelStays)
{
  StructureChain chain;
  chain.trust_up = true;
  ASSERT_TRUE(chain.findStructure(turnedFlat(1))) << chain.problem;
  EXPECT_FALSE(chain.levelling);
}

} // namespace

// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include <pcl/sedr_surface/structure_chain.h>

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(StructureChain, TellsEveryResultWhileItsStageStillKnowsIt)
{
  // Two rooms 10 cm apart, of one height.
  RoomPoints points;
  points.room(rectangle(0.01, 0.01, 4.01, 3.01), 0, 2.5);
  points.room(rectangle(4.11, 0.01, 8.11, 3.01), 0, 2.5);
  StructureChain chain;
  std::vector<std::pair<std::string, std::uint32_t>> told;
  std::map<std::uint32_t, std::size_t> walls;
  chain.on_result = [&](const std::string& stage, std::uint32_t room) {
    told.emplace_back(stage, room);
    if (stage == "GridRegionOutlierRemoval") {
      EXPECT_EQ(chain.outlier_removal.getRegionMap().regions.sizes.size(), 2u);
    }
    if (stage == "RoomSegmentation") {
      EXPECT_EQ(chain.getRoomRegions().size(), 2u);
    }
    if (stage == "GridSliceDetail") {
      EXPECT_FALSE(chain.slice_detail.getAnalysis().trials.empty());
    }
    if (stage == "CeilingBoundaryWallGrowing")
      walls[room] = chain.wall_growing.getWallIndices().size();
  };
  ASSERT_TRUE(chain.findStructure(points.cloud())) << chain.problem;
  const std::vector<std::pair<std::string, std::uint32_t>> expected{
      {"HorizontalPlaneDetection", 0},
      {"GridRegionOutlierRemoval", 0},
      {"RoomSegmentation", 0},
      {"GridSliceDetail", 1},
      {"GridSliceDetail", 2},
      {"FloorProjectionRecovery", 1},
      {"FloorProjectionRecovery", 2},
      {"CeilingBoundaryWallGrowing", 1},
      {"CeilingBoundaryWallGrowing", 2},
      {"FloorplanFitting", 0},
      {"StructureRefinement", 0},
      {"VerticalHoleRepair", 0},
      {"FloorplanExtrusion", 0}};
  EXPECT_EQ(told, expected);
  EXPECT_GT(walls[1], 1000u);
  EXPECT_GT(walls[2], 1000u);
}

} // namespace

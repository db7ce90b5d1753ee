// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_filters/structure_refinement.h>
#include <pcl/sedr_filters/vertical_hole_repair.h>

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

using Structure = pcl::PointCloud<pcl::PointStructure>;

/** Four points of a floor of 4 m by 3 m. */
Structure::Ptr
floorPoints()
{
  auto cloud = std::make_shared<Structure>();
  for (const float x : {0.5f, 1.5f, 2.5f, 3.5f}) {
    pcl::PointStructure p{};
    p.x = x;
    p.y = 1;
    p.label = static_cast<std::uint32_t>(StructureLabel::Floor);
    p.room = 1;
    cloud->push_back(p);
  }
  return cloud;
}

std::shared_ptr<Floorplan>
planOf(const PlanLoop& boundary)
{
  auto plan = std::make_shared<Floorplan>();
  plan->rooms.push_back(roomOf(boundary, 2.5));
  return plan;
}

TEST(StructureRefinement, LabelsAndRoomsThatAreSetStandForThoseOfThePoints)
{
  pcl::StructureRefinement<pcl::PointStructure> refinement;
  refinement.setInputCloud(floorPoints());
  refinement.setFloorplan(planOf(rectangle(0, 0, 4, 3)));
  refinement.setLabels({2, 1, 2, 2}); // the second of the ceiling, far from it
  refinement.setRooms({1, 1, 2, 1});  // the third of a room without a plan
  Structure refined;
  refinement.filter(refined);
  ASSERT_EQ(refinement.getErrorMessage(), "");
  EXPECT_EQ(refinement.getSourceIndices(), (pcl::Indices{0, 3}));
}

TEST(VerticalHoleRepair, TooManyCellsAreRefusedBeforeTheyAreMade)
{
  pcl::VerticalHoleRepair<pcl::PointStructure> repair(true);
  repair.setInputCloud(floorPoints());
  repair.setFloorplan(planOf(rectangle(0, 0, 4, 3)));
  Structure whole;
  for (const double size : {1e-4, 1e-12, 1e-300, 5e-324}) {
    repair.setGridSize(size);
    repair.filter(whole);
    EXPECT_NE(repair.getErrorMessage().find("at most 2e+08"), std::string::npos)
        << size << ": " << repair.getErrorMessage();
    EXPECT_TRUE(whole.empty());
    EXPECT_EQ(repair.getRemovedIndices()->size(), 4u);
  }
  repair.setGridSize(0.5);
  repair.filter(whole);
  EXPECT_EQ(repair.getErrorMessage(), "");
  EXPECT_FALSE(whole.empty());
}

} // namespace

// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_scan.h"
#include "simulator/scene/scenes.h"

#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <gtest/gtest.h>

#include <memory>
#include <ostream>
#include <string>

namespace {

namespace sim = pcl::sedr::sim;

struct LabelledScene {
  std::string scene;
  std::size_t rooms;
  std::size_t walls;
  double worst_mean; ///< metres from truth to solid
};

std::ostream&
operator<<(std::ostream& stream, const LabelledScene& e)
{
  return stream << e.scene;
}

class LabelledStoreys : public testing::TestWithParam<LabelledScene> {};

TEST_P(LabelledStoreys, haveTheRoomsAndWallsThatWereScanned)
{
  const sim::Scene scene = sim::sceneNamed(GetParam().scene);
  pcl::IndoorStructureReconstruction<pcl::PointXYZ> chain;
  chain.setInputCloud(sim::cloudOf(scene));
  chain.getStages().floorplan_fitting.setLabelStoreys(true);
  ASSERT_TRUE(chain.findStructure()) << chain.getErrorMessage();
  const auto plan = chain.getFloorplan();
  EXPECT_EQ(plan->rooms.size(), GetParam().rooms);
  std::size_t walls = 0;
  double area = 0;
  for (const pcl::sedr::PlanRoom& room : plan->rooms) {
    walls += room.boundary.elements.size();
    area += room.area();
  }
  double true_area = 0;
  for (const sim::Room& room : scene.rooms)
    true_area += room.boundary.area();
  EXPECT_EQ(walls, GetParam().walls);
  EXPECT_NEAR(area, true_area, 0.002 * true_area);
  const auto figures =
      sim::figuresOf(chain.getStages().extrusion.getMesh(), sim::truthInScan(scene));
  EXPECT_LE(figures.truth_to_mesh->mean, GetParam().worst_mean);
}

TEST(LabelledStorey, hasItsWallsBeforeWindowsAndTheirReveals)
{
  pcl::IndoorStructureReconstruction<pcl::PointXYZ> chain;
  chain.setInputCloud(
      sim::cloudOf(sim::sceneNamed("big_windows"), sim::noiseAndSeed(0.01, 3)));
  chain.getStages().floorplan_fitting.setLabelStoreys(true);
  ASSERT_TRUE(chain.findStructure()) << chain.getErrorMessage();
  ASSERT_EQ(chain.getFloorplan()->rooms.size(), 1U);
  EXPECT_EQ(chain.getFloorplan()->rooms[0].boundary.elements.size(), 4U);
  EXPECT_NEAR(chain.getFloorplan()->rooms[0].area(), 42, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Scenes,
                         LabelledStoreys,
                         testing::Values(LabelledScene{"syn_flat", 4, 19, 0.001},
                                         LabelledScene{"bls_room", 1, 4, 0.003},
                                         LabelledScene{"two_storeys", 4, 16, 0.003}));

} // namespace

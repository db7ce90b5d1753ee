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

struct ExpectedCeiling {
  std::string scene;
  std::size_t walls;
  std::size_t facets; ///< besides the main one
  double radius;      ///< of the curves; 0: none
};

std::ostream&
operator<<(std::ostream& stream, const ExpectedCeiling& e)
{
  return stream << e.scene;
}

class Ceiling : public testing::TestWithParam<ExpectedCeiling> {};

TEST_P(Ceiling, becomesAClosedSolidWithinAHairOfTheTruth)
{
  sim::Scene scene =
      sim::sceneNamed(std::string(CEILING_SCENES) + "/" + GetParam().scene + ".json");
  for (sim::Scanner& scanner : scene.scanners) {
    scanner.noise = 0.01;
    scanner.rays_per_station /= 2; // to save time
  }
  pcl::IndoorStructureReconstruction<pcl::PointXYZ> chain;
  chain.setInputCloud(sim::cloudOf(scene));
  ASSERT_TRUE(chain.findStructure()) << chain.getErrorMessage();

  const auto plan = chain.getFloorplan();
  ASSERT_EQ(plan->rooms.size(), 1U);
  const pcl::sedr::PlanRoom& room = plan->rooms[0];
  EXPECT_EQ(room.boundary.elements.size(), GetParam().walls);
  EXPECT_EQ(room.details.size(), GetParam().facets);
  for (int d = -1; d < static_cast<int>(room.details.size()); ++d)
    if (const auto& curve = room.ceilingSlab(d).curve) {
      EXPECT_NEAR(curve->across, GetParam().radius, 0.01 * GetParam().radius);
    }

  const auto& reports = chain.getStages().extrusion.getReports();
  ASSERT_EQ(reports.size(), 1U);
  EXPECT_TRUE(reports[0].closed) << reports[0].problem;
  const auto figures =
      sim::figuresOf(chain.getStages().extrusion.getMesh(), sim::truthInScan(scene));
  EXPECT_LE(figures.truth_to_mesh->mean, 0.0005);
  EXPECT_GE(figures.truth_to_mesh->within_1cm, 0.98);
}

INSTANTIATE_TEST_SUITE_P(Ceilings,
                         Ceiling,
                         testing::Values(ExpectedCeiling{"gable_attic", 4, 1, 0},
                                         ExpectedCeiling{"shed_roof", 6, 0, 0},
                                         ExpectedCeiling{"hip_roof", 4, 3, 0},
                                         ExpectedCeiling{"barrel_vault", 4, 0, 2.5},
                                         ExpectedCeiling{"segmental_vault", 4, 0, 4},
                                         ExpectedCeiling{"dome", 4, 1, 3},
                                         ExpectedCeiling{"jack_arches", 4, 3, 1.84}));

} // namespace

// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"
#include "two_storeys.h"

#include <pcl/sedr_filters/impl/refinement.h>
#include <pcl/sedr_filters/impl/structure_fields.hpp>
#include <pcl/sedr_filters/vertical_hole_repair.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>
#include <pcl/sedr_surface/mesh_evaluation.h>
#include <pcl/sedr_surface/structural_poisson.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Extrusion = pcl::FloorplanExtrusion<pcl::PointXYZ>;

/** The solids of two storeys; the walls of the upper one are shifted by 0.3 m. */
struct Building {
  Floorplan plan = twoStoreys(0.3);
  Extrusion extrusion;

  Building()
  {
    extrusion.setFloorplan(plan);
    pcl::PolygonMesh unused;
    extrusion.reconstruct(unused);
  }
};

TEST(StoreysOfSolids, AreAClosedSolidARoomThatMeetNowhere)
{
  const Building building;
  EXPECT_TRUE(building.extrusion.isClosed());
  EXPECT_TRUE(building.extrusion.getWarnings().empty());
  ASSERT_EQ(building.extrusion.getReports().size(), 4u);
  for (std::size_t r = 0; r < 4; ++r)
    EXPECT_NEAR(building.extrusion.getReports()[r].volume,
                building.plan.rooms[r].area() * (r < 2 ? 2.5 : 2.4), 1e-5);
  EXPECT_EQ(checkTopology(building.extrusion.getMesh()).components.size(), 4u);
}

TEST(StoreysOfSolids, OfPoissonAreOneClosedMeshARoomToo)
{
  const Floorplan plan = twoStoreys(0.3);
  pcl::PointCloud<pcl::PointStructure>::Ptr cloud(
      new pcl::PointCloud<pcl::PointStructure>);
  for (const RepairedPoint& point : repairHoles({}, plan, 0.1)) {
    cloud->emplace_back();
    setSurfacePoint(point.point, cloud->back());
  }
  pcl::StructuralPoisson<pcl::PointStructure> poisson;
  poisson.setInputCloud(cloud);
  poisson.setDepth(6);
  pcl::PolygonMesh unused;
  poisson.reconstruct(unused);
  EXPECT_EQ(poisson.getErrorMessage(), "");
  ASSERT_EQ(poisson.getReports().size(), 4u);
  for (std::size_t r = 0; r < 4; ++r) {
    EXPECT_TRUE(poisson.getReports()[r].closed) << r;
    EXPECT_NEAR(std::abs(poisson.getReports()[r].volume),
                plan.rooms[r].area() * (r < 2 ? 2.5 : 2.4), 1);
  }
}

} // namespace

// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include "sedr_surface/src/poisson/plan_samples.h"
#include <pcl/sedr_surface/mesh_distance.h>
#include <pcl/sedr_surface/room_solid.h>
#include <pcl/sedr_surface/structural_poisson.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

constexpr double spacing = 0.1;

TEST(StructuralPoissonOfAPlan, IsClosedAndKeepsItsEdges)
{
  auto plan = std::make_shared<Floorplan>();
  plan->rooms = {roomOf(rectangle(0, 0, 4, 3), 2.5, 7),
                 roomOf(rectangle(4.1, 0, 6, 3), 2.5, 3)};
  pcl::StructuralPoisson<pcl::PointStructure> poisson;
  poisson.setFloorplan(plan);
  poisson.setPlanSpacing(spacing);
  pcl::PolygonMesh mesh;
  poisson.reconstruct(mesh);
  EXPECT_EQ(poisson.getErrorMessage(), "");
  EXPECT_TRUE(poisson.isClosed());
  ASSERT_EQ(poisson.getReports().size(), 2u);
  EXPECT_EQ(poisson.getReports()[0].room, 7u);
  EXPECT_NEAR(poisson.getReports()[0].volume, 30, 0.15);
  EXPECT_EQ(poisson.getMesh().labels.size(), poisson.getMesh().triangles.size());

  TriangleMesh solid;
  std::vector<SolidElement> elements;
  for (const PlanRoom& room : plan->rooms) {
    TriangleMesh one;
    extrudeRoom(room, {}, one, elements);
    solid.append(one);
  }
  const auto off = summarizeDistances(
      MeshDistance(poisson.getMesh()).distances(sampleMesh(solid, 0.02, 1).points));
  EXPECT_LT(off.max, spacing / 2);
  EXPECT_LT(off.mean, spacing / 30);
}

TEST(StructuralPoissonOfAPlan, RefusesOneWithoutRoomsAndBadSpacings)
{
  pcl::StructuralPoisson<pcl::PointNormal> poisson;
  poisson.setFloorplan(std::make_shared<Floorplan>());
  pcl::PolygonMesh mesh;
  poisson.reconstruct(mesh);
  EXPECT_NE(poisson.getErrorMessage().find("no rooms"), std::string::npos);
  auto plan = std::make_shared<Floorplan>();
  plan->rooms = {roomOf(rectangle(0, 0, 4, 3), 2.5)};
  poisson.setFloorplan(plan);
  for (const double bad : {0.0, -1.0, std::nan("")}) {
    poisson.setPlanSpacing(bad);
    poisson.reconstruct(mesh);
    EXPECT_TRUE(mesh.polygons.empty());
    EXPECT_NE(poisson.getErrorMessage().find("spacing"), std::string::npos);
  }
}

} // namespace

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

TEST(PlanSamples, LieOnTheRoomAndFaceIntoIt)
{
  const PlanSamples samples = samplePlan(roomOf(rectangle(0, 0, 4, 3), 2.5), spacing);
  ASSERT_EQ(samples.problem, "");
  ASSERT_EQ(samples.labels.size(), samples.points.size());
  const Eigen::Vector3d size(4, 3, 2.5);
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    const Eigen::Vector3d p = samples.points[i].position.cast<double>();
    const Eigen::Vector3d n = samples.points[i].normal.cast<double>();
    const Eigen::Vector3d inside = p + 0.01 * n;
    EXPECT_NEAR(std::min(p.minCoeff(), (size - p).minCoeff()), 0, 1e-5);
    EXPECT_NEAR(n.norm(), 1, 1e-6);
    EXPECT_GT(std::min(inside.minCoeff(), (size - inside).minCoeff()), -1e-5);
    EXPECT_EQ(samples.labels[i], n.z() > 0.5 ? 2u : n.z() < -0.5 ? 1u : 3u);
  }
}

TEST(PlanSamples, AreDenserAtEdgesAndEvenElsewhere)
{
  const PlanSamples samples = samplePlan(roomOf(rectangle(0, 0, 4, 3), 2.5), spacing);
  std::size_t at_edges = 0;
  std::size_t elsewhere = 0;
  for (const OrientedPoint& point : samples.points) {
    const Eigen::Vector3f& p = point.position;
    if (point.normal.z() < 0.5f)
      continue; // only the floor
    const float off = std::min(std::min(p.x(), 4 - p.x()), std::min(p.y(), 3 - p.y()));
    ++(off < 2 * spacing ? at_edges : elsewhere);
  }
  const double inner = 3.6 * 2.6;
  EXPECT_NEAR(static_cast<double>(elsewhere), inner / 0.01, 0.05 * inner / 0.01);
  const double rim = 12 - inner;
  EXPECT_NEAR(static_cast<double>(at_edges), rim / 0.0016, 0.05 * rim / 0.0016);
}

TEST(PlanSamples, FacetsOfAnArcAreNoEdges)
{
  const PlanSamples samples = samplePlan(roomOf(circle({0, 0}, 2), 2.5), spacing);
  const auto in_the_middle = std::count_if(
      samples.points.begin(), samples.points.end(), [](const OrientedPoint& p) {
        return p.position.z() > 0.5f && p.position.z() < 2.0f;
      });
  const double area = 4 * M_PI * 1.5;
  EXPECT_NEAR(static_cast<double>(in_the_middle), area / 0.01, 0.05 * area / 0.01);
}

TEST(PlanSamples, OfARoomThatCannotBeBuiltAreNone)
{
  const PlanSamples samples = samplePlan(PlanRoom(), spacing);
  EXPECT_TRUE(samples.points.empty());
  EXPECT_NE(samples.problem, "");
}

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

// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include <pcl/sedr_surface/indoor_structure_reconstruction.h>
#include <pcl/sedr_surface/mesh_evaluation.h>

#include <gtest/gtest.h>

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
  ASSERT_TRUE(level.findStructure(turnedFlat(0))) << level.getModel().problem;
  EXPECT_FALSE(level.getModel().levelling);
  EXPECT_TRUE(level.getModel().warnings.empty());
  for (const double degrees : {0.5, 2.9}) {
    SCOPED_TRACE(degrees);
    StructureChain chain;
    ASSERT_TRUE(chain.findStructure(turnedFlat(degrees))) << chain.getModel().problem;
    ASSERT_TRUE(chain.getModel().levelling);
    EXPECT_NEAR(chain.getModel().levelling->angle() * 180 / M_PI, degrees, 0.1);
    ASSERT_EQ(chain.getModel().warnings.size(), 1u);
    EXPECT_EQ(chain.getModel().warnings[0].kind, WarningKind::Levelled);
    ASSERT_EQ(chain.getModel().plan->rooms.size(), 2u);
    for (std::size_t r = 0; r < 2; ++r) {
      const PlanRoom& room = chain.getModel().plan->rooms[r];
      const PlanRoom& truth = level.getModel().plan->rooms[r];
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
  ASSERT_TRUE(chain.findStructure(scan)) << chain.getModel().problem;
  std::vector<Eigen::Vector3d> points;
  for (const auto& p : *scan)
    points.push_back(p.getVector3fMap().cast<double>());
  const auto farthest = [&](const TriangleMesh& mesh) {
    return summarizeDistances(MeshDistance(mesh).distances(points)).max;
  };
  EXPECT_LT(
      farthest(chain.getModel().inScanFrame(chain.getStages().extrusion.getMesh())),
      0.02);
  const auto structure = chain.getModel().structureInScanFrame();
  ASSERT_EQ(structure->size(), chain.getModel().structure->size());
  ScanAssumptions known;
  known.keep_levelled = true;
  chain.setAssumptions(known);
  ASSERT_TRUE(chain.findStructure(scan)) << chain.getModel().problem;
  EXPECT_GT(
      farthest(chain.getModel().inScanFrame(chain.getStages().extrusion.getMesh())),
      0.05);
  EXPECT_EQ(chain.getModel().structureInScanFrame(), chain.getModel().structure);
}

/** A room of 5 m x 4 m below the lower of some planes. Its wall at y = 4 m tilts into
 * it, that at x = 0 out of it, each by `tilt`. */
StructureChain::Cloud::Ptr
tiltedBelow(const std::vector<PlanSlab>& slopes, double tilt)
{
  constexpr double step = 0.04;
  const double run = std::tan(tilt);
  const auto ceilingAt = [&](double x, double y) {
    double height = 1e9;
    for (const PlanSlab& slope : slopes)
      height = std::min(height, slope.heightAt({x, y}));
    return height;
  };
  const auto isWithin = [&](const Eigen::Vector3d& p) {
    return p.x() > -run * p.z() && p.x() < 5 && p.y() > 0 && p.y() < 4 - run * p.z() &&
           p.z() > 0 && p.z() < ceilingAt(p.x(), p.y());
  };
  RoomPoints points(step, 0.002);
  points.slab(rectangle(0, 0, 5, 4), 0);
  for (const PlanSlab& slope : slopes)
    points.slab(rectangle(-2, 0, 5, 4), slope, [&](double x, double y) {
      return isWithin({x, y, slope.heightAt({x, y}) - 1e-6});
    });
  for (const double y : {0.0, 4.0})
    for (double x = -2; x < 5; x += step)
      for (double z = step / 2; z < 5; z += step)
        if (const double at = y - (y > 0 ? run * z : 0);
            isWithin({x, at + (y > 0 ? -1e-6 : 1e-6), z}))
          points.point(x, at, z);
  for (const double x : {0.0, 5.0})
    for (double y = step / 2; y < 4; y += step)
      for (double z = step / 2; z < 5; z += step)
        if (const double at = x - (x > 0 ? 0 : run * z);
            isWithin({at + (x > 0 ? -1e-6 : 1e-6), y, z}))
          points.point(at, y, z);
  return points.cloud();
}

double
farthestFrom(const TriangleMesh& mesh, const StructureChain::Cloud& scan)
{
  std::vector<Eigen::Vector3d> points;
  for (const auto& p : scan)
    points.push_back(p.getVector3fMap().cast<double>());
  return summarizeDistances(MeshDistance(mesh).distances(points)).max;
}

std::vector<double>
tiltsOf(const StructureChain& chain)
{
  std::vector<double> tilts;
  for (const PlanRoom& room : chain.getModel().plan->rooms)
    for (const PlanElement& wall : room.boundary.elements)
      if (wall.tilt != 0)
        tilts.push_back(wall.tilt);
  return tilts;
}

TEST(StructureChainTilt, ASlopingCeilingOverTiltedWallsIsOnePlane)
{
  const PlanSlab truth = slabAt(2.4, 0.25, -0.1);
  const auto scan = tiltedBelow({truth}, 15 * M_PI / 180);
  StructureChain chain;
  ASSERT_TRUE(chain.findStructure(scan)) << chain.getModel().problem;
  ASSERT_EQ(chain.getModel().plan->rooms.size(), 1u);
  const PlanRoom& room = chain.getModel().plan->rooms[0];
  EXPECT_EQ(tiltsOf(chain).size(), 2u);
  EXPECT_EQ(room.boundary.elements.size(), 4u);
  EXPECT_TRUE(room.details.empty());
  const Eigen::Vector3d normal = truth.plane.head<3>().normalized();
  EXPECT_LT(std::acos(std::min(1.0, normal.dot(room.ceiling.plane.head<3>()))),
            0.1 * M_PI / 180);
  EXPECT_LT(farthestFrom(chain.getStages().extrusion.getMesh(), *scan), 0.02);
}

TEST(StructureChainTilt, WallsThatTiltByADegreeAreExact)
{
  for (const double degrees : {1.2, 4.5}) {
    const auto scan = tiltedBelow({slabAt(2.6, 0, 0)}, degrees * M_PI / 180);
    StructureChain chain;
    ASSERT_TRUE(chain.findStructure(scan)) << chain.getModel().problem;
    ASSERT_EQ(tiltsOf(chain).size(), 2u) << degrees;
    for (const double tilt : tiltsOf(chain))
      EXPECT_NEAR(std::abs(tilt), degrees * M_PI / 180, 0.0005) << degrees;
    EXPECT_LT(farthestFrom(chain.getStages().extrusion.getMesh(), *scan), 0.02)
        << degrees;
  }
}

TEST(StructureChainTilt, IsThatOfTheSlabsNotOfWallsOutOfPlumb)
{
  RoomPoints sheared(0.05, 0.003);
  sheared.room(rectangle(0, 0, 6, 4), 0, 2.5);
  const auto scan = sheared.cloud();
  for (auto& p : *scan)
    p.x += static_cast<float>(std::tan(1.5 * M_PI / 180)) * p.z;
  StructureChain chain;
  ASSERT_TRUE(chain.findStructure(scan)) << chain.getModel().problem;
  EXPECT_FALSE(chain.getModel().levelling);
}

TEST(StructureChainTilt, HalfADegreeIsATolerance)
{
  StructureChain chain;
  ASSERT_TRUE(chain.findStructure(tiltedBelow({slabAt(2.6, 0, 0)}, 0.5 * M_PI / 180)));
  EXPECT_TRUE(tiltsOf(chain).empty());
}

} // namespace

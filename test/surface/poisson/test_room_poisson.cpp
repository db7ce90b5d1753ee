// SPDX-License-Identifier: BSD-3-Clause
#include "oriented_rooms.h"
#include "sedr_surface/src/mesh/mesh_repair.h"

#include "sedr_surface/src/poisson/room_poisson.h"
#include "sedr_surface/src/solver/surface_samples.h"
#include <pcl/sedr_surface/mesh_distance.h>

#include <gtest/gtest.h>

using namespace pcl::sedr;
using namespace sedr_test;

namespace {

/** 6 m x 5 m x 3 m. */
PlanRoom
boxRoom()
{
  return roomOf(rectangle(0, 0, 6, 5), 3);
}

struct Case {
  const char* name;
  PlanRoom room;
  int euler;
  double degrees;
  Eigen::Vector3d shift;
};

// Expects a mesh close enough to the room.
void
expectGood(const TriangleMesh& truth,
           const TriangleMesh& mesh,
           const RoomPoissonReport& report,
           int euler)
{
  EXPECT_TRUE(report.closed) << report.problem;
  const MeshTopology topology = checkTopology(mesh);
  EXPECT_TRUE(topology.isClosedManifold()) << topology.problem();
  EXPECT_EQ(topology.components.size(), 1u);
  EXPECT_EQ(topology.euler_characteristic, euler);
  EXPECT_NEAR(mesh.signedVolume() / truth.signedVolume(), 1, 0.005);
  EXPECT_LT(mesh.signedVolume(), 0); // normals into the room
  const DistanceStatistics completeness = summarizeDistances(
      MeshDistance(mesh).distances(sampleMesh(truth, 0.05, 1).points));
  const DistanceStatistics precision = summarizeDistances(
      MeshDistance(truth).distances(sampleMesh(mesh, 0.05, 1).points));
  EXPECT_LT(completeness.mean, 0.003);
  EXPECT_GT(completeness.within_5cm, 0.97);
  EXPECT_LT(precision.mean, 0.003);
  EXPECT_GT(precision.within_5cm, 0.98);
}

} // namespace

TEST(RoomPoisson, rooms_of_perfect_points_come_back)
{
  PlanRoom l = boxRoom(); // without a quarter
  l.boundary = polygon({{0, 0}, {6, 0}, {6, 2.5}, {3, 2.5}, {3, 5}, {0, 5}});
  PlanRoom soffit = boxRoom(); // 1 m wide along two walls
  soffit.details = {
      detailOf(polygon({{0, 0}, {6, 0}, {6, 1}, {1, 1}, {1, 5}, {0, 5}}), 2.5)};
  PlanRoom column = boxRoom();
  column.columns = {reversed(circle({2.5, 3}, 0.3))};
  for (const Case& c : {Case{"box", boxRoom(), 2, 17, {0.13, 0.27, 0.31}},
                        {"L", l, 2, 0, {3, -2, 0}},
                        {"soffit", soffit, 2, 30, {0.1, 0, 0}},
                        {"column", column, 0, 8, {0, 0, -1}}}) {
    SCOPED_TRACE(c.name);
    // Coarser than the default to save time.
    const auto points = placed(orientedPoints(c.room, 1. / 12), c.degrees, c.shift);
    auto [mesh, report] =
        surfaceOf({0, points, std::vector<std::uint32_t>(points.size(), 3)}, {});
    ASSERT_FALSE(mesh.empty()) << report.problem;
    const Eigen::AngleAxisd turn(c.degrees * M_PI / 180, Eigen::Vector3d::UnitZ());
    TriangleMesh truth = solidOf(c.room);
    for (Eigen::Vector3d& v : truth.vertices)
      v = turn * v + c.shift;
    expectGood(truth, mesh, report, c.euler);
    EXPECT_EQ(report.points, points.size());
    EXPECT_NEAR(report.spacing, 1. / 12, 0.006);
    EXPECT_NEAR(report.cell, 0.8 * report.spacing, 0.15 * report.spacing);
    EXPECT_EQ(report.unsupported_share, 0);
    EXPECT_EQ(mesh.labels, std::vector<std::uint32_t>(mesh.triangles.size(), 3));
  }
}

TEST(RoomPoisson, sheets_that_meet_in_one_vertical_edge_stay_apart)
{
  // Two pillars, or a soffit above an object: the vertices of both sheets move to the
  // common edge, and some to the same point on it.
  const PlanLoop one = rectangle(1, 1, 1.5, 1.5);
  const PlanLoop other = rectangle(1.5, 1.5, 2, 2);
  PlanRoom pillars = roomOf(rectangle(0, 0, 3, 3), 2.5);
  PlanRoom crossed = pillars;
  pillars.columns = {reversed(one), reversed(other)};
  crossed.details = {detailOf(one, 1.5)};
  crossed.floor_details = {detailOf(other, 1.5)};
  std::size_t parted = 0;
  for (const auto& [room, volume] :
       {std::pair(pillars, 8.5 * 2.5), std::pair(crossed, 9 * 2.5 - 0.25 * 2.5)})
    for (const double degrees : {0.0, 8.0, 17.0, 45.0}) {
      SCOPED_TRACE(degrees);
      const auto points = placed(orientedPoints(room, 0.1), degrees, {0.1, 0.03, 0});
      auto [mesh, report] = surfaceOf({0, points}, {});
      ASSERT_FALSE(mesh.empty()) << report.problem;
      EXPECT_TRUE(report.closed) << report.problem;
      EXPECT_EQ(weldVertices(mesh), 0u);
      EXPECT_TRUE(checkTopology(mesh).isClosedManifold());
      EXPECT_NEAR(report.volume, volume, 0.05);
      parted += report.parted_vertices;
    }
  EXPECT_GT(parted, 0u) << "the case is not met";
}

TEST(RoomPoisson, large_coordinates_cost_no_more_than_their_own_digits)
{
  // A float resolves 8 mm there.
  auto [mesh, report] = surfaceOf(
      {0, placed(orientedPoints(boxRoom(), 0.125), 17, {100000, -60000, 250})}, {});
  ASSERT_FALSE(mesh.empty()) << report.problem;
  EXPECT_TRUE(report.closed) << report.problem;
  EXPECT_NEAR(report.volume, 90, 1);
  std::size_t off_float = 0;
  for (const auto& v : mesh.vertices)
    for (int k = 0; k < 3; ++k)
      off_float += v[k] != static_cast<double>(static_cast<float>(v[k])) ? 1 : 0;
  EXPECT_EQ(off_float, 0u);
}

TEST(RoomPoisson, points_that_enclose_nothing_do_not_pass_as_a_room)
{
  std::vector<OrientedPoint> floor;
  for (const auto& p : orientedPoints(boxRoom(), 0.125))
    if (p.normal.z() > 0.5)
      floor.push_back(p);
  const RoomPoissonReport report = surfaceOf({0, floor}, {}).report;
  EXPECT_FALSE(report.closed);
  EXPECT_FALSE(report.problem.empty());
}

TEST(RoomPoisson, points_as_far_away_as_numbers_go_are_refused)
{
  for (const float far : {1e7F, 1e20F, 3e38F}) {
    auto points = orientedPoints(boxRoom(), 0.125);
    points[7].position.x() = far;
    points[8].position.y() = -far;
    const auto [mesh, report] = surfaceOf({0, points}, {});
    EXPECT_TRUE(mesh.empty()) << far;
    EXPECT_EQ(report.problem, "its points extend over more than 1000000 m: remove "
                              "those that are far from the others");
  }
}

TEST(RoomPoisson, a_room_without_a_floor_comes_with_a_warning)
{
  std::vector<OrientedPoint> points;
  for (const auto& p : orientedPoints(boxRoom(), 0.125))
    if (p.normal.z() < 0.5)
      points.push_back(p);
  auto [mesh, report] = surfaceOf({0, points}, {});
  ASSERT_FALSE(mesh.empty()) << report.problem;
  EXPECT_GT(report.unsupported_share, 0.2);
  EXPECT_NE(report.warning.find("% of its surface is a guess"), std::string::npos);
}

TEST(RoomPoisson, of_two_rooms_that_are_apart_one_is_told_to_be_missing)
{
  auto points = orientedPoints(smallRoom(), 0.125);
  const std::string warning = surfaceOf({0, points}, {}).report.warning;
  EXPECT_TRUE(warning.empty()) << warning;
  const std::size_t half = points.size();
  for (std::size_t i = 0; i < half; ++i) {
    points.push_back(points[i]);
    points.back().position.x() += 5;
  }
  const RoomPoissonReport report = surfaceOf({0, points}, {}).report;
  EXPECT_NE(report.warning.find("2 surfaces"), std::string::npos) << report.warning;
  EXPECT_NE(report.warning.find("50 %"), std::string::npos) << report.warning;
}

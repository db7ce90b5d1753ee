// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_surface/src/mesh/mesh_repair.h"
#include "surface/chain/lattice_room.h"

#include "sedr_surface/src/poisson/room_poisson.h"
#include "sedr_surface/src/solver/surface_samples.h"
#include <pcl/sedr_surface/mesh_distance.h>

#include <gtest/gtest.h>

using namespace pcl::sedr;
using namespace sedr_test;

namespace {

struct Case {
  const char* name;
  LatticeRoom room;
  int euler;
};

// Expects a mesh close enough to the room.
void
expectGood(const LatticeRoom& room,
           const TriangleMesh& mesh,
           const RoomPoissonReport& report,
           int euler)
{
  EXPECT_TRUE(report.closed) << report.problem;
  const MeshTopology topology = checkTopology(mesh);
  EXPECT_TRUE(topology.isClosedManifold()) << topology.problem();
  EXPECT_EQ(topology.components.size(), 1u);
  EXPECT_EQ(topology.euler_characteristic, euler);
  const TriangleMesh truth = room.truth();
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
  const Case cases[] = {{"box", boxRoom().placed(17, {0.13, 0.27, 0.31}), 2},
                        {"L", lRoom().placed(0, {3, -2, 0}), 2},
                        {"soffit", soffitRoom().placed(30, {0.1, 0, 0}), 2},
                        {"column", columnRoom().placed(8, {0, 0, -1}), 0}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const auto points = c.room.points(1. / 12); // coarser than the default to save time
    auto [mesh, report] =
        surfaceOf({0, points, std::vector<std::uint32_t>(points.size(), 3)}, {});
    ASSERT_FALSE(mesh.empty()) << report.problem;
    expectGood(c.room, mesh, report, c.euler);
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
  const auto pillars = [](int x, int y, int) {
    return !((x == 2 && y == 2) || (x == 3 && y == 3));
  };
  const auto crossed = [](int x, int y, int z) {
    return !((x == 2 && y == 2 && z >= 3) || (x == 3 && y == 3 && z < 3));
  };
  std::size_t parted = 0;
  for (const LatticeRoom& room :
       {LatticeRoom(6, 6, 5, pillars), LatticeRoom(6, 6, 5, crossed)})
    for (const double degrees : {0.0, 8.0, 17.0, 45.0}) {
      SCOPED_TRACE(degrees);
      const auto points = LatticeRoom(room).placed(degrees, {0.1, 0.03, 0}).points(0.1);
      auto [mesh, report] = surfaceOf({0, points}, {});
      ASSERT_FALSE(mesh.empty()) << report.problem;
      EXPECT_TRUE(report.closed) << report.problem;
      EXPECT_EQ(weldVertices(mesh), 0u);
      EXPECT_TRUE(checkTopology(mesh).isClosedManifold());
      EXPECT_NEAR(report.volume, room.truth().signedVolume() * -1, 0.05);
      parted += report.parted_vertices;
    }
  EXPECT_GT(parted, 0u) << "the case is not met";
}

TEST(RoomPoisson, large_coordinates_cost_no_more_than_their_own_digits)
{
  // A float resolves 8 mm there.
  const LatticeRoom room = boxRoom().placed(17, {100000, -60000, 250});
  auto [mesh, report] = surfaceOf({0, room.points(0.125)}, {});
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
  for (const auto& p : boxRoom().points(0.125))
    if (p.normal.z() > 0.5)
      floor.push_back(p);
  const RoomPoissonReport report = surfaceOf({0, floor}, {}).report;
  EXPECT_FALSE(report.closed);
  EXPECT_FALSE(report.problem.empty());
}

TEST(RoomPoisson, points_as_far_away_as_numbers_go_are_refused)
{
  for (const float far : {1e7F, 1e20F, 3e38F}) {
    auto points = boxRoom().points(0.125);
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
  for (const auto& p : boxRoom().points(0.125))
    if (p.normal.z() < 0.5)
      points.push_back(p);
  auto [mesh, report] = surfaceOf({0, points}, {});
  ASSERT_FALSE(mesh.empty()) << report.problem;
  EXPECT_GT(report.unsupported_share, 0.2);
  EXPECT_NE(report.warning.find("% of its surface is a guess"), std::string::npos);
}

TEST(RoomPoisson, of_two_rooms_that_are_apart_one_is_told_to_be_missing)
{
  auto points = LatticeRoom(6, 5, 5).points(0.125);
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

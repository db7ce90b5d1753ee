// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_surface/src/mesh/mesh_repair.h"
#include "surface/chain/lattice_room.h"

#include "sedr_surface/src/poisson/room_poisson.h"
#include "sedr_surface/src/solver/point_spacing.h"
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

TEST(LatticeRoom, truths_are_closed_and_of_the_volume_of_their_blocks)
{
  const std::pair<LatticeRoom, double> rooms[] = {{boxRoom(), 90},
                                                  {lRoom(), 67.5},
                                                  {soffitRoom(), 85},
                                                  {columnRoom(), 90 - M_PI * 0.09 * 3}};
  for (const auto& entry : rooms) {
    const TriangleMesh truth = entry.first.truth();
    EXPECT_TRUE(checkTopology(truth).isClosedManifold());
    EXPECT_NEAR(truth.signedVolume(), -entry.second, 0.005);
    const DistanceStatistics off =
        summarizeDistances(MeshDistance(truth).distances([&] {
          std::vector<Eigen::Vector3d> points;
          for (const auto& p : entry.first.points(0.1))
            points.push_back(p.position.cast<double>());
          return points;
        }()));
    EXPECT_LT(off.max, 2e-4); // the facets of the column
  }
}

TEST(RoomPoisson, the_spacing_of_a_grid_is_its_step)
{
  EXPECT_NEAR(measureSpacing(boxRoom().points(0.1)), 0.1, 0.01);
  EXPECT_NEAR(measureSpacing(boxRoom().points(0.05)), 0.05, 0.005);
}

TEST(RoomPoisson, rooms_of_perfect_points_come_back)
{
  const Case cases[] = {{"box", boxRoom().placed(17, {0.13, 0.27, 0.31}), 2},
                        {"L", lRoom().placed(0, {3, -2, 0}), 2},
                        {"soffit", soffitRoom().placed(30, {0.1, 0, 0}), 2},
                        {"column", columnRoom().placed(8, {0, 0, -1}), 0}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    TriangleMesh mesh;
    std::vector<std::uint32_t> nearest;
    RoomPoissonReport report;
    const auto points = c.room.points(1. / 12); // coarser than the default to save time
    ASSERT_TRUE(reconstructRoom(points, {}, mesh, nearest, report)) << report.problem;
    expectGood(c.room, mesh, report, c.euler);
    EXPECT_EQ(report.points, points.size());
    EXPECT_NEAR(report.spacing, 1. / 12, 0.006);
    EXPECT_NEAR(report.cell, 0.8 * report.spacing, 0.15 * report.spacing);
    EXPECT_EQ(report.unsupported_share, 0);
    EXPECT_EQ(nearest.size(), mesh.triangles.size());
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
      TriangleMesh mesh;
      std::vector<std::uint32_t> nearest;
      RoomPoissonReport report;
      const auto points = LatticeRoom(room).placed(degrees, {0.1, 0.03, 0}).points(0.1);
      ASSERT_TRUE(reconstructRoom(points, {}, mesh, nearest, report)) << report.problem;
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
  TriangleMesh mesh;
  std::vector<std::uint32_t> nearest;
  RoomPoissonReport report;
  ASSERT_TRUE(reconstructRoom(room.points(0.125), {}, mesh, nearest, report));
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
  TriangleMesh mesh;
  std::vector<std::uint32_t> nearest;
  RoomPoissonReport report;
  reconstructRoom(floor, {}, mesh, nearest, report);
  EXPECT_FALSE(report.closed);
  EXPECT_FALSE(report.problem.empty());
}

TEST(RoomPoisson, a_room_without_a_floor_comes_with_a_warning)
{
  std::vector<OrientedPoint> points;
  for (const auto& p : boxRoom().points(0.125))
    if (p.normal.z() < 0.5)
      points.push_back(p);
  TriangleMesh mesh;
  std::vector<std::uint32_t> nearest;
  RoomPoissonReport report;
  ASSERT_TRUE(reconstructRoom(points, {}, mesh, nearest, report));
  EXPECT_GT(report.unsupported_share, 0.2);
  EXPECT_NE(report.warning.find("% of its surface is a guess"), std::string::npos);
}

TEST(RoomPoisson, two_dense_walls_do_not_make_the_cells_finer_than_the_rest_bears)
{
  std::vector<OrientedPoint> points;
  for (const auto& p : boxRoom().points(0.05))
    if (std::abs(p.normal.x()) > 0.5)
      points.push_back(p);
  const std::size_t dense = points.size();
  for (const auto& p : boxRoom().points(0.125))
    if (std::abs(p.normal.x()) < 0.5)
      points.push_back(p);
  EXPECT_GT(dense, points.size() / 2); // share of points, not of area
  EXPECT_NEAR(measureSpacing(points), 0.125, 0.02);
}

TEST(RoomPoisson, crumbs_and_bubbles_are_dropped)
{
  const LatticeRoom room = LatticeRoom(6, 5, 5);
  auto points = room.points(0.125);
  // A ball of 0.5 m radius in the middle of the room with normals outwards: a separate
  // closed shell.
  for (int i = 0; i < 400; ++i) {
    const double z = 1 - (2 * i + 1) / 400.;
    const double turn = 2.399963229728653 * i; // the golden angle
    const double r = std::sqrt(1 - z * z);
    const Eigen::Vector3d n(r * std::cos(turn), r * std::sin(turn), z);
    points.push_back(
        {(Eigen::Vector3d(1.5, 1.25, 1.25) + 0.5 * n).cast<float>(), n.cast<float>()});
  }
  TriangleMesh mesh;
  std::vector<std::uint32_t> nearest;
  RoomPoissonReport report;
  ASSERT_TRUE(reconstructRoom(points, {}, mesh, nearest, report));
  EXPECT_TRUE(report.closed) << report.problem;
  EXPECT_EQ(report.removed_components, 1u);
  EXPECT_NEAR(report.volume, 3 * 2.5 * 2.5, 0.3);
}

TEST(RoomPoisson, of_two_rooms_that_are_apart_one_is_told_to_be_missing)
{
  auto points = LatticeRoom(6, 5, 5).points(0.125);
  TriangleMesh mesh;
  std::vector<std::uint32_t> nearest;
  RoomPoissonReport report;
  ASSERT_TRUE(reconstructRoom(points, {}, mesh, nearest, report));
  EXPECT_TRUE(report.warning.empty()) << report.warning;
  const std::size_t half = points.size();
  for (std::size_t i = 0; i < half; ++i) {
    points.push_back(points[i]);
    points.back().position.x() += 5;
  }
  report = {};
  ASSERT_TRUE(reconstructRoom(points, {}, mesh, nearest, report));
  EXPECT_NE(report.warning.find("2 surfaces"), std::string::npos) << report.warning;
  EXPECT_NE(report.warning.find("50 %"), std::string::npos) << report.warning;
}

TEST(RoomPoisson, all_points_in_one_place_are_refused)
{
  std::vector<OrientedPoint> points(200, {{1, 2, 3}, {0, 0, 1}});
  TriangleMesh mesh;
  std::vector<std::uint32_t> nearest;
  RoomPoissonReport report;
  EXPECT_FALSE(reconstructRoom(points, {}, mesh, nearest, report));
  EXPECT_NE(report.problem.find("200 points extend over 0"), std::string::npos)
      << report.problem;
  EXPECT_TRUE(mesh.empty());
}

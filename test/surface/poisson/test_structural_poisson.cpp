// SPDX-License-Identifier: BSD-3-Clause
#include "oriented_rooms.h"
#include "says.h"
#include "sedr_surface/src/mesh/mesh_repair.h"

#include <pcl/PolygonMesh.h>
#include <pcl/sedr_surface/mesh_evaluation.h>
#include <pcl/sedr_surface/structural_poisson.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <gtest/gtest.h>

#include <limits>

using namespace pcl::sedr;
using namespace sedr_test;

namespace {

constexpr double coarse = 0.125; // metres between points, to save time

template <typename PointNT>
typename pcl::PointCloud<PointNT>::Ptr
cloudOf(const std::vector<OrientedPoint>& points)
{
  auto cloud = std::make_shared<pcl::PointCloud<PointNT>>();
  for (const auto& p : points) {
    PointNT point;
    point.getVector3fMap() = p.position;
    point.getNormalVector3fMap() = p.normal;
    cloud->push_back(point);
  }
  return cloud;
}

// Two rooms, 7 and 3, with a wall of 10 cm between them, as one cloud.
pcl::PointCloud<pcl::PointStructure>::Ptr
twoRooms()
{
  const auto points = orientedPoints(smallRoom(), coarse);
  auto cloud = cloudOf<pcl::PointStructure>(points);
  for (auto& p : *cloud) {
    p.room = 7;
    p.label = p.normal_z > 0.5f ? 2 : p.normal_z < -0.5f ? 1 : 3;
  }
  auto second = cloudOf<pcl::PointStructure>(placed(points, 0, {3.1, 0, 0}));
  for (auto& p : *second)
    p.room = 3;
  *cloud += *second;
  return cloud;
}

/** The surface of points without rooms. */
RoomSurface
surfaceOf(const std::vector<OrientedPoint>& points)
{
  pcl::StructuralPoisson<pcl::PointNormal> poisson;
  poisson.setInputCloud(cloudOf<pcl::PointNormal>(points));
  poisson.makeMesh();
  return {poisson.getMesh(), poisson.getReports().at(0)};
}

/** 6 m x 5 m x 3 m. */
PlanRoom
boxRoom()
{
  return roomOf(rectangle(0, 0, 6, 5), 3);
}

template <typename PointNT>
void
expectReason(pcl::StructuralPoisson<PointNT>& poisson, const std::string& part)
{
  pcl::PolygonMesh mesh;
  mesh.polygons.resize(3);
  poisson.reconstruct(mesh);
  EXPECT_TRUE(says(poisson.getErrorMessage(), part));
  EXPECT_TRUE(mesh.polygons.empty());
  EXPECT_EQ(mesh.cloud.width * mesh.cloud.height, 0u);
  EXPECT_TRUE(poisson.getMesh().rooms.empty());
  EXPECT_FALSE(poisson.isClosed());
  pcl::PointCloud<PointNT> points;
  points.resize(3);
  std::vector<pcl::Vertices> polygons(3);
  poisson.reconstruct(points, polygons);
  EXPECT_TRUE(points.empty());
  EXPECT_TRUE(polygons.empty());
}

} // namespace

TEST(StructuralPoisson,
     each_room_becomes_one_closed_component_that_knows_its_room_and_labels)
{
  const auto cloud = twoRooms();
  *cloud += *cloudOf<pcl::PointStructure>(
      placed(orientedPoints(smallRoom(), coarse), 0, {-4, 0, 0})); // of no room
  pcl::StructuralPoisson<pcl::PointStructure> poisson;
  poisson.setInputCloud(cloud);
  pcl::PolygonMesh output;
  poisson.reconstruct(output);
  EXPECT_EQ(poisson.getErrorMessage(), "");
  EXPECT_TRUE(poisson.isClosed());
  TriangleMesh mesh;
  ASSERT_EQ(fromPolygonMesh(output, mesh), "");
  const MeshTopology topology = checkTopology(mesh);
  EXPECT_TRUE(topology.isClosedManifold()) << topology.problem();
  ASSERT_EQ(topology.components.size(), 2u);
  for (const auto& component : topology.components)
    EXPECT_NEAR(component.signed_volume, -3 * 2.5 * 2.5, 0.3);
  ASSERT_EQ(poisson.getReports().size(), 2u);
  EXPECT_EQ(poisson.getReports()[0].room, 3u);
  EXPECT_EQ(poisson.getReports()[1].room, 7u);
  const auto& rooms = poisson.getMesh().rooms;
  ASSERT_EQ(rooms.size(), mesh.triangles.size());
  const auto& labels = poisson.getMesh().labels;
  ASSERT_EQ(labels.size(), mesh.triangles.size());
  std::size_t level = 0;
  for (std::size_t t = 0; t < rooms.size(); ++t) {
    EXPECT_EQ(rooms[t], mesh.corner(t, 0).x() > 3.05 ? 3u : 7u);
    const double up = mesh.scaledNormal(t).normalized().z();
    if (rooms[t] != 7 || std::abs(up) < 0.99)
      continue;
    ++level;
    EXPECT_EQ(labels[t], up > 0 ? 2u : 1u);
  }
  EXPECT_GT(level, 100u);
}

TEST(StructuralPoisson, bad_points_are_skipped_and_counted_and_normals_scaled)
{
  auto cloud = cloudOf<pcl::PointXYZRGBNormal>(orientedPoints(smallRoom(), coarse));
  const std::size_t good = cloud->size() - 3;
  (*cloud)[5].x = std::numeric_limits<float>::quiet_NaN();
  (*cloud)[6].normal_y = std::numeric_limits<float>::infinity();
  (*cloud)[7].getNormalVector3fMap().setZero();
  (*cloud)[8].getNormalVector3fMap() *= 3;
  pcl::StructuralPoisson<pcl::PointXYZRGBNormal> poisson;
  poisson.setInputCloud(cloud);
  poisson.makeMesh();
  ASSERT_EQ(poisson.getReports().size(), 1u);
  EXPECT_EQ(poisson.getReports()[0].points, good);
  EXPECT_EQ(poisson.getReports()[0].skipped_points, 3u);
  EXPECT_EQ(poisson.getReports()[0].scaled_normals, 1u);
  EXPECT_TRUE(poisson.isClosed());
}

TEST(StructuralPoisson, a_room_that_fails_is_named_and_the_others_are_made)
{
  auto cloud = twoRooms();
  for (int i = 0; i < 20; ++i)
    (*cloud)[i].room = 12;
  pcl::StructuralPoisson<pcl::PointStructure> poisson;
  poisson.setInputCloud(cloud);
  pcl::PolygonMesh output;
  poisson.reconstruct(output);
  EXPECT_FALSE(output.polygons.empty());
  EXPECT_FALSE(poisson.isClosed());
  EXPECT_TRUE(
      says(poisson.getErrorMessage(),
           "room 12 has no surface: 100 points with normals are needed, there are 20"));
  EXPECT_EQ(poisson.getReports().size(), 3u);
}

TEST(StructuralPoisson, bad_input_leaves_nothing_but_a_reason)
{
  for (const float far : {1e4f, 1e6f, 3e38f}) {
    const auto with_stray =
        cloudOf<pcl::PointNormal>(orientedPoints(smallRoom(), coarse));
    with_stray->back().x = far;
    pcl::StructuralPoisson<pcl::PointNormal> of_stray;
    of_stray.setInputCloud(with_stray);
    expectReason(of_stray, "remove those that are far from the others");
  }
  pcl::StructuralPoisson<pcl::PointNormal> poisson;
  expectReason(poisson, "no input cloud is set");
  poisson.setInputCloud(std::make_shared<pcl::PointCloud<pcl::PointNormal>>());
  expectReason(poisson, "the input cloud is empty");
  const auto cloud = cloudOf<pcl::PointNormal>(orientedPoints(smallRoom(), 0.25));
  poisson.setInputCloud(cloud);
  poisson.setIndices(std::make_shared<pcl::Indices>(pcl::Indices{3}));
  expectReason(poisson, "there are 1");
  auto without = std::make_shared<pcl::PointCloud<pcl::PointNormal>>(*cloud);
  for (auto& p : *without)
    p.getNormalVector3fMap().setZero();
  pcl::StructuralPoisson<pcl::PointNormal> other;
  other.setInputCloud(without);
  expectReason(other, "points with normals are needed, there are 0");
}

TEST(StructuralPoisson, rooms_of_perfect_points_come_back)
{
  PlanRoom l = boxRoom(); // without a quarter
  l.boundary = polygon({{0, 0}, {6, 0}, {6, 2.5}, {3, 2.5}, {3, 5}, {0, 5}});
  PlanRoom soffit = boxRoom(); // 1 m wide along two walls
  soffit.details = {
      detailOf(polygon({{0, 0}, {6, 0}, {6, 1}, {1, 1}, {1, 5}, {0, 5}}), 2.5)};
  PlanRoom column = boxRoom();
  column.columns = {reversed(circle({2.5, 3}, 0.3))};
  for (const auto& [room, euler, degrees, shift] :
       {std::tuple(boxRoom(), 2, 17, Eigen::Vector3d(0.13, 0.27, 0.31)),
        {l, 2, 0, {3, -2, 0}},
        {soffit, 2, 30, {0.1, 0, 0}},
        {column, 0, 8, {0, 0, -1}}}) {
    SCOPED_TRACE(degrees);
    const auto [mesh, report] =
        surfaceOf(placed(orientedPoints(room, 1. / 12), degrees, shift));
    TriangleMesh truth = solidOf(room);
    const Eigen::AngleAxisd turn(degrees * M_PI / 180, Eigen::Vector3d::UnitZ());
    for (Eigen::Vector3d& v : truth.vertices)
      v = turn * v + shift;
    EXPECT_TRUE(report.closed) << report.problem;
    const MeshTopology topology = checkTopology(mesh);
    EXPECT_TRUE(topology.isClosedManifold()) << topology.problem();
    EXPECT_EQ(topology.components.size(), 1u);
    EXPECT_EQ(topology.euler_characteristic, euler);
    EXPECT_LT(mesh.signedVolume(), 0) << "normals into the room";
    EXPECT_NEAR(mesh.signedVolume() / truth.signedVolume(), 1, 0.005);
    for (const auto& [from, to] :
         {std::pair(&std::as_const(truth), &mesh), {&mesh, &truth}}) {
      const DistanceStatistics off = summarizeDistances(
          MeshDistance(*to).distances(sampleMesh(*from, 0.05, 1).points));
      EXPECT_LT(off.mean, 0.003);
      EXPECT_GT(off.within_5cm, 0.97);
    }
    EXPECT_NEAR(report.cell, 0.8 * report.spacing, 0.15 * report.spacing);
    EXPECT_EQ(report.unsupported_share, 0);
  }
}

TEST(StructuralPoisson, whatever_the_points_the_surface_is_closed_or_there_is_none)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<float> any(-1, 1);
  int surfaces = 0;
  for (int run = 0; run < 12; ++run) {
    std::vector<OrientedPoint> points;
    for (int i = 0; i < 100 << (run % 4); ++i) {
      const Eigen::Vector3f normal(any(random), any(random), any(random));
      points.push_back({{any(random), any(random), any(random)}, normal.normalized()});
    }
    const auto [mesh, report] = surfaceOf(points);
    EXPECT_TRUE(!mesh.empty() || !report.problem.empty());
    surfaces += mesh.empty() ? 0 : 1;
    EXPECT_TRUE(mesh.empty() || checkTopology(mesh).isClosedManifold())
        << checkTopology(mesh).problem();
  }
  EXPECT_GT(surfaces, 0);
}

TEST(StructuralPoisson, a_thin_wall_in_a_room_has_no_holes_from_a_cell_on)
{
  constexpr double spacing = 0.05;
  for (const double thickness : {0.05, 0.07})
    for (const double degrees : {0., 17., 45.}) {
      SCOPED_TRACE(std::to_string(thickness) + ", " + std::to_string(degrees));
      PlanRoom room = roomOf(rectangle(0, 0, 2, 1.7), 1);
      room.columns = {reversed(rectangle(0.5, 0.8, 1.5, 0.8 + thickness))};
      const auto [mesh, report] =
          surfaceOf(placed(orientedPoints(room, spacing), degrees, {0, 0, 0}));
      EXPECT_TRUE(report.closed) << report.problem;
      EXPECT_EQ(checkTopology(mesh).euler_characteristic, 0) << "a ring";
      EXPECT_NEAR(mesh.signedVolume(), thickness - 2 * 1.7, 0.02);
    }
}

TEST(StructuralPoisson, sheets_that_meet_in_one_vertical_edge_stay_apart)
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
      auto [mesh, report] =
          surfaceOf(placed(orientedPoints(room, 0.1), degrees, {0.1, 0.03, 0}));
      EXPECT_TRUE(report.closed) << report.problem;
      EXPECT_EQ(weldVertices(mesh), 0u);
      EXPECT_TRUE(checkTopology(mesh).isClosedManifold());
      EXPECT_NEAR(report.volume, volume, 0.05);
      parted += report.parted_vertices;
    }
  EXPECT_GT(parted, 0u) << "the case is not met";
}

TEST(StructuralPoisson, large_coordinates_cost_no_more_than_their_own_digits)
{
  // A float resolves 8 mm there.
  const auto [mesh, report] =
      surfaceOf(placed(orientedPoints(boxRoom(), coarse), 17, {100000, -60000, 250}));
  EXPECT_TRUE(report.closed) << report.problem;
  EXPECT_NEAR(report.volume, 90, 1);
  for (const auto& v : mesh.vertices)
    ASSERT_EQ(v, v.cast<float>().cast<double>());
}

TEST(StructuralPoisson, tells_what_of_a_surface_is_a_guess_or_missing)
{
  std::vector<OrientedPoint> floor;
  std::vector<OrientedPoint> others;
  for (const auto& p : orientedPoints(boxRoom(), coarse))
    (p.normal.z() > 0.5 ? floor : others).push_back(p);
  const RoomPoissonReport open = surfaceOf(floor).report;
  EXPECT_FALSE(open.closed);
  EXPECT_FALSE(open.problem.empty());
  const auto [mesh, report] = surfaceOf(others);
  ASSERT_FALSE(mesh.empty()) << report.problem;
  EXPECT_GT(report.unsupported_share, 0.2);
  EXPECT_TRUE(says(report.warning, "% of its surface is a guess"));

  auto points = orientedPoints(smallRoom(), coarse);
  EXPECT_EQ(surfaceOf(points).report.warning, "");
  for (OrientedPoint p : orientedPoints(smallRoom(), coarse)) {
    p.position.x() += 5;
    points.push_back(p);
  }
  const std::string warning = surfaceOf(points).report.warning;
  EXPECT_TRUE(says(warning, "2 surfaces", "50 %"));
}

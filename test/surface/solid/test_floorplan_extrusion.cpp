// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include <pcl/sedr_surface/floorplan_extrusion.h>
#include <pcl/sedr_surface/impl/mesh_reconstruction.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <gtest/gtest.h>

#include <limits>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;
using Extrusion = pcl::FloorplanExtrusion<pcl::PointXYZ>;

/** Two rooms with a partition of 10 cm between them, the second with a column. */
std::shared_ptr<Floorplan>
twoRooms()
{
  auto plan = std::make_shared<Floorplan>();
  plan->rooms = {roomOf(rectangle(0, 0, 4, 5), 2.5, 3),
                 roomOf(rectangle(4.1, 0, 9, 5), 2.7, 8)};
  plan->rooms[1].columns.push_back(reversed(rectangle(6, 2, 6.5, 2.5)));
  return plan;
}

TEST(FloorplanExtrusion, OneClosedSolidARoom)
{
  Extrusion extrusion;
  extrusion.setFloorplan(twoRooms());
  pcl::PolygonMesh output;
  extrusion.reconstruct(output);
  EXPECT_EQ(extrusion.getErrorMessage(), "");
  EXPECT_TRUE(extrusion.isClosed());
  EXPECT_TRUE(extrusion.getWarnings().empty());
  ASSERT_EQ(extrusion.getReports().size(), 2u);
  EXPECT_NEAR(extrusion.getReports()[0].volume, 4 * 5 * 2.5, 1e-5);
  EXPECT_NEAR(extrusion.getReports()[1].volume, (4.9 * 5 - 0.25) * 2.7, 1e-5);
  EXPECT_EQ(extrusion.getReports()[1].topology.euler_characteristic, 0);
  const MeshTopology topology = checkTopology(extrusion.getMesh());
  EXPECT_TRUE(topology.isClosedManifold()) << topology.problem();
  EXPECT_EQ(topology.components.size(), 2u);
  EXPECT_EQ(output.polygons.size(), extrusion.getMesh().triangles.size());
  EXPECT_EQ(output.cloud.width, extrusion.getMesh().vertices.size());
}

TEST(FloorplanExtrusion, RoomsWithoutAWallBetweenThemDoNotCross)
{
  const auto plan = twoRooms();
  Extrusion extrusion;
  extrusion.setFloorplan(plan);
  pcl::PolygonMesh output;
  for (const auto& [begin, warnings] : {std::make_pair(4.0, 0u), {3.9, 1u}}) {
    plan->rooms[1].boundary = rectangle(begin, 0, 9, 5);
    extrusion.reconstruct(output);
    EXPECT_TRUE(extrusion.isClosed()) << "each by itself";
    ASSERT_EQ(extrusion.getWarnings().size(), warnings);
  }
  EXPECT_EQ(sentenceOf(extrusion.getWarnings()[0]),
            "room 3: its solid runs into that of room 8");
}

TEST(FloorplanExtrusion, TrianglesKnowTheirElement)
{
  Extrusion extrusion;
  extrusion.setFloorplan(twoRooms());
  pcl::PolygonMesh output;
  extrusion.reconstruct(output);
  const TriangleMesh& mesh = extrusion.getMesh();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const SolidElement& element = extrusion.getElements().at(mesh.elements[t] - 1);
    EXPECT_EQ(element.room, mesh.rooms[t]);
    EXPECT_EQ(static_cast<std::uint32_t>(element.label), mesh.labels[t]);
    const bool is_partition = element.name == "room_3_wall_2";
    const bool is_there = mesh.corner(t, 0).x() == 4 && mesh.corner(t, 1).x() == 4 &&
                          mesh.corner(t, 2).x() == 4;
    EXPECT_EQ(is_partition, is_there);
  }
}

TEST(FloorplanExtrusion, PointsGetRoomAndNormalWhereTheyHaveSuch)
{
  pcl::FloorplanExtrusion<pcl::PointStructure> extrusion;
  extrusion.setFloorplan(twoRooms());
  pcl::PointCloud<pcl::PointStructure> points;
  std::vector<pcl::Vertices> polygons;
  extrusion.reconstruct(points, polygons);
  ASSERT_EQ(points.size(), 8u + 16u);
  EXPECT_EQ(polygons.size(), extrusion.getMesh().triangles.size());
  for (const auto& p : points) {
    EXPECT_EQ(p.room, p.x < 4.05f ? 3u : 8u);
    EXPECT_NEAR(p.getNormalVector3fMap().norm(), 1, 1e-5);
  }
  // At the low south-west corner of the first room, normals point out of the room.
  for (const auto& p : points)
    if (p.x == 0 && p.y == 0 && p.z == 0) {
      EXPECT_LT(p.getNormalVector3fMap().maxCoeff(), 0);
    }
}

TEST(FloorplanExtrusion, WhatIsMissingOrOutOfRangeIsTold)
{
  Extrusion extrusion;
  pcl::PolygonMesh output;
  output.polygons.resize(3);
  extrusion.reconstruct(output);
  EXPECT_EQ(extrusion.getErrorMessage(), "no floor plan is set");
  EXPECT_TRUE(output.polygons.empty());
  extrusion.setFloorplan(std::make_shared<Floorplan>());
  extrusion.reconstruct(output);
  EXPECT_EQ(extrusion.getErrorMessage(), "the floor plan has 0 rooms");
  extrusion.setFloorplan(twoRooms());
  extrusion.setChordTolerance(2);
  extrusion.reconstruct(output);
  EXPECT_NE(extrusion.getErrorMessage().find("chord tolerance"), std::string::npos);
  EXPECT_TRUE(extrusion.getMesh().empty());
  EXPECT_FALSE(extrusion.isClosed());
  extrusion.setChordTolerance(0.001);
  extrusion.reconstruct(output);
  EXPECT_EQ(extrusion.getErrorMessage(), "");
  EXPECT_FALSE(output.polygons.empty());
}

TEST(FloorplanExtrusion, ARoomThatCannotBeBuiltDoesNotStopTheOthers)
{
  auto plan = twoRooms();
  plan->rooms[0].boundary.elements[1].end.x() =
      std::numeric_limits<double>::quiet_NaN();
  Extrusion extrusion;
  extrusion.setFloorplan(plan);
  pcl::PolygonMesh output;
  extrusion.reconstruct(output);
  EXPECT_FALSE(extrusion.isClosed());
  EXPECT_NE(extrusion.getErrorMessage().find("room 3"), std::string::npos);
  ASSERT_FALSE(extrusion.getMesh().empty());
  for (const auto room : extrusion.getMesh().rooms)
    EXPECT_EQ(room, 8u);
  for (const auto element : extrusion.getMesh().elements)
    EXPECT_EQ(extrusion.getElements().at(element - 1).room, 8u);
}

} // namespace

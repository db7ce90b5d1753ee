// SPDX-License-Identifier: BSD-3-Clause
#include "says.h"
#include "solid_checks.h"

#include <pcl/sedr_surface/impl/mesh_reconstruction.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <limits>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(RoomSolid, ARectangleIsABoxOfTwelveTriangles)
{
  const Solid solid(roomOf(rectangle(1, 2, 7, 7), 2.5, 4));
  expectPiece(solid, 6 * 5 * 2.5);
  EXPECT_EQ(solid.mesh.triangles.size(), 12u);
  EXPECT_EQ(solid.mesh.vertices.size(), 8u);
  for (const double x : {1, 7})
    for (const double y : {2, 7})
      for (const double z : {0., 2.5})
        EXPECT_TRUE(solid.hasVertex(x, y, z));
  EXPECT_EQ(solid.names(),
            (std::set<std::string>{"room_4_floor", "room_4_ceiling", "room_4_wall_1",
                                   "room_4_wall_2", "room_4_wall_3", "room_4_wall_4"}));
  EXPECT_NEAR(solid.areaOf("room_4_wall_1"), 6 * 2.5, 1e-6);
  EXPECT_NEAR(solid.areaOf("room_4_wall_2"), 5 * 2.5, 1e-6);
  EXPECT_NEAR(solid.report.wall_area, 2 * 11 * 2.5, 1e-5);
  EXPECT_NEAR(solid.report.floor_area, 30, 1e-5);
  EXPECT_NEAR(solid.report.ceiling_area, 30, 1e-5);
  EXPECT_TRUE(solid.report.warnings.empty());
}

TEST(RoomSolid, ARoundRoomKeepsTheChordTolerance)
{
  const PlanLoop loop = circle({1, 2}, 3.5);
  for (const double tolerance : {0.0005, 0.01, 0.1}) {
    SolidParameters parameters;
    parameters.chord_tolerance = tolerance;
    const Solid solid(roomOf(loop, 2.5), parameters);
    const auto n = static_cast<double>(solid.mesh.vertices.size()) / 2;
    expectPiece(solid, n / 2 * 3.5 * 3.5 * std::sin(2 * M_PI / n) * 2.5);
    EXPECT_LE(3.5 * (1 - std::cos(M_PI / n)), tolerance);
    EXPECT_GT(3.5 * (1 - std::cos(M_PI / (n - 1))), tolerance) << "no more than needed";
    for (const auto& v : solid.mesh.vertices)
      EXPECT_NEAR((v.head<2>() - Eigen::Vector2d(1, 2)).norm(), 3.5, 1e-6);
    EXPECT_EQ(solid.names().size(), 3u) << "one wall";
  }
}

TEST(RoomSolid, TangentArcsAndASCurve)
{
  const PlanLoop rounded = roundedRectangle(6, 4, 1);
  expectPiece(Solid(roomOf(rounded, 2.5)), facetArea(rounded) * 2.5);
  EXPECT_NEAR(facetArea(rounded), 6 * 4 - 4 + M_PI, 0.005);
  // The lower wall curves out and then in: two quarter circles of radius 2.
  const PlanLoop s{{arc({0, 2}, 2, 270, 360), arc({4, 2}, 2, 180, 90),
                    segment({4, 4}, {4, 7}), segment({4, 7}, {0, 7}),
                    segment({0, 7}, {0, 0})}};
  const Solid solid(roomOf(s, 3));
  expectPiece(solid, facetArea(s) * 3);
  EXPECT_NEAR(facetArea(s), s.area(), 0.005);
  EXPECT_TRUE(solid.hasVertex(2, 2, 0));
  EXPECT_TRUE(solid.hasVertex(2, 2, 3));
}

TEST(RoomSolid, ABeamACofferAndASoffitAllAround)
{
  PlanRoom room = roomOf(rectangle(0, 0, 6, 5), 2.5);
  room.details.push_back(detailOf(rectangle(1, 1, 2, 4), 2.2));
  room.details.push_back(detailOf(rectangle(3, 1, 5, 4), 2.9));
  expectPiece(Solid(room), 30 * 2.5 - 3 * 0.3 + 6 * 0.4);
  room.details = {detailOf(rectangle(0, 0, 6, 5), 2.1)};
  room.details[0].holes.push_back(reversed(rectangle(1, 1, 5, 4)));
  const Solid ring(room);
  expectPiece(ring, 30 * 2.1 + 12 * 0.4);
  EXPECT_NEAR(ring.areaOf("room_1_detail_1_hole_1_edge_2"), 4 * 0.4, 1e-5);
  EXPECT_FALSE(ring.hasVertex(0, 0, 2.5));
}

TEST(RoomSolid, ATiltedCeilingHasItsHeightAtTheCentroid)
{
  PlanRoom room = roomOf(polygon({{0, 0}, {8, 0}, {8, 3}, {3, 3}, {3, 7}, {0, 7}}), 3);
  room.ceiling = slabAt(3, 0.05, -0.03);
  room.floor = slabAt(0.1, 0.01, 0.02);
  const double x = (24 * 4 + 12 * 1.5) / 36;
  const double y = (24 * 1.5 + 12 * 5) / 36;
  expectPiece(Solid(room), 36 * (2.9 + 0.04 * x - 0.05 * y));
}

TEST(RoomSolid, ATiltedDetailThatGoesThroughTheCeiling)
{
  // Its underside rises from 2.3 to 2.7 m over 4 m: below the ceiling up to x = 3.
  PlanRoom room = roomOf(rectangle(0, 0, 6, 5), 2.5);
  room.details.push_back(detailOf(rectangle(1, 1, 5, 4), 0));
  room.details[0].slab = slabAt(2.2, 0.1);
  const Solid solid(room);
  expectPiece(solid, 30 * 2.5);
  EXPECT_TRUE(solid.hasVertex(3, 1, 2.5));
  EXPECT_TRUE(solid.hasVertex(3, 4, 2.5));
}

TEST(RoomSolid, APlatformWithAStepBesideTheWall)
{
  PlanRoom room = roomOf(rectangle(0, 0, 6, 5), 2.5);
  room.floor_details.push_back(detailOf(rectangle(4, 0, 6, 5), 0.4));
  room.floor_details.push_back(detailOf(rectangle(3.7, 0, 4, 5), 0.2));
  room.floor_details.push_back(detailOf(rectangle(1, 1, 2, 2), -0.3)); // a pit
  const Solid solid(room);
  expectPiece(solid, 30 * 2.5 - 10 * 0.4 - 1.5 * 0.2 + 0.3);
  EXPECT_NEAR(solid.areaOf("room_1_floor_detail_1"), 10, 1e-5);
  EXPECT_NEAR(solid.areaOf("room_1_floor_detail_2_edge_4"), 5 * 0.2, 1e-5);
  EXPECT_NEAR(solid.areaOf("room_1_floor_detail_2_edge_2"), 5 * 0.2, 1e-5);
  EXPECT_NEAR(solid.areaOf("room_1_floor_detail_3_edge_1"), 0.3, 1e-5);
  EXPECT_NEAR(solid.report.floor_area, 30, 1e-5) << "whatever its height";
  EXPECT_NEAR(solid.report.riser_area, 5 * 0.4 + 4 * 0.3, 1e-5);
}

TEST(RoomSolid, ANicheInAWall)
{
  PlanRoom room = roomOf(rectangle(0, 0, 6, 5), 2.5);
  room.niches.push_back({rectangle(1, 5, 2, 5.3), slabAt(0.8), slabAt(1.8)});
  const Solid solid(room);
  expectPiece(solid, 30 * 2.5 + 0.3);
  EXPECT_NEAR(solid.areaOf("room_1_niche_1_bottom"), 0.3, 1e-5);
  EXPECT_NEAR(solid.areaOf("room_1_niche_1_top"), 0.3, 1e-5);
  EXPECT_NEAR(solid.areaOf("room_1_niche_1_side_3"), 1, 1e-5) << "its back";
  EXPECT_NEAR(solid.report.riser_area, 0, 1e-5);
  EXPECT_NEAR(solid.report.wall_area, 2 * 11 * 2.5 + 2 * 0.3, 1e-5) << "with its sides";
  EXPECT_EQ(solid.names().count("room_1_niche_1_side_1"), 0u) << "where it is open";
  EXPECT_NEAR(solid.areaOf("room_1_wall_3"), 6 * 2.5 - 1, 1e-5);
  room.niches[0].bottom = slabAt(0); // down to the floor
  expectPiece(Solid(room), 30 * 2.5 + 0.3 * 1.8);
  // In a round wall, its front coincides with the facets.
  PlanRoom round = roomOf(circle({0, 0}, 3), 2.5);
  round.niches.push_back({rectangle(2.9, -0.5, 3.4, 0.5), slabAt(0.8), slabAt(1.8)});
  const Solid in_round(round);
  expectSound(in_round);
  const double beyond = 1 * 3.4 - 9 * std::asin(0.5 / 3) - 0.5 * std::sqrt(9 - 0.25);
  EXPECT_NEAR(in_round.report.volume, facetArea(round.boundary) * 2.5 + beyond, 1e-3);
}

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
  EXPECT_TRUE(says(extrusion.getErrorMessage(), "chord tolerance"));
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
  EXPECT_TRUE(says(extrusion.getErrorMessage(), "room 3"));
  ASSERT_FALSE(extrusion.getMesh().empty());
  for (const auto room : extrusion.getMesh().rooms)
    EXPECT_EQ(room, 8u);
  for (const auto element : extrusion.getMesh().elements)
    EXPECT_EQ(extrusion.getElements().at(element - 1).room, 8u);
}

} // namespace

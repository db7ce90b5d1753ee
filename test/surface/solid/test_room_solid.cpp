// SPDX-License-Identifier: BSD-3-Clause
#include "solid_checks.h"

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

TEST(RoomSolid, AColumnIsATunnel)
{
  PlanRoom room = roomOf(rectangle(0, 0, 6, 5), 2.5);
  room.columns.push_back(reversed(circle({2, 2}, 0.35)));
  const double round = facetArea(circle({2, 2}, 0.35));
  expectPiece(Solid(room), (30 - round) * 2.5, 0);
  room.columns.push_back(reversed(rectangle(4, 2, 4.5, 2.5)));
  const Solid solid(room);
  expectPiece(solid, (30 - round - 0.25) * 2.5, -2);
  EXPECT_EQ(solid.names().count("room_1_column_1_face_1"), 1u);
  EXPECT_NEAR(solid.areaOf("room_1_column_2_face_4"), 0.5 * 2.5, 1e-6);
  const auto chords = circle({2, 2}, 0.35).polygon(SolidParameters().chord_tolerance);
  EXPECT_EQ(std::count(solid.mesh.labels.begin(), solid.mesh.labels.end(),
                       static_cast<std::uint32_t>(StructureLabel::Column)),
            8 + 2 * static_cast<std::ptrdiff_t>(chords.size()));
}

TEST(RoomSolid, ASoffitAtAWall)
{
  PlanRoom room = roomOf(rectangle(0, 0, 6, 5), 2.5);
  room.details.push_back(detailOf(rectangle(0, 4, 6, 5), 2.2));
  const Solid solid(room);
  expectPiece(solid, 30 * 2.5 - 6 * 0.3);
  EXPECT_NEAR(solid.areaOf("room_1_detail_1"), 6, 1e-5);
  EXPECT_NEAR(solid.areaOf("room_1_detail_1_edge_1"), 6 * 0.3, 1e-5);
  EXPECT_EQ(solid.names().count("room_1_detail_1_edge_2"), 0u) << "lies on a wall";
  EXPECT_NEAR(solid.areaOf("room_1_wall_2"), 4 * 2.5 + 2.2, 1e-5);
  for (const double x : {0, 6})
    for (const double z : {2.2, 2.5})
      EXPECT_TRUE(solid.hasVertex(x, 4, z));
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

} // namespace

// SPDX-License-Identifier: BSD-3-Clause
#include "two_storeys.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/floorplan_ifc.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

// The output is checked by test_ifc_schema.py and test_ifc_web.py.

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

std::size_t
count(const std::string& text, const std::string& part)
{
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++n;
  return n;
}

Floorplan
joinedRooms()
{
  Floorplan plan{
      {roomOf(rectangle(0, 0, 4, 3), 2.5), roomOf(rectangle(4.1, 0, 8, 3), 2.5, 2)}};
  plan.openings = {{OpeningKind::Passage, {1, 2}, {}, {4.05, 1}, {4.05, 1.9}, 0, 2.05}};
  return plan;
}

TEST(WriteIfc, TellsWhatIsInIt)
{
  const IfcModel model = writeIfc(joinedRooms());
  EXPECT_EQ(model.spaces, 2u);
  EXPECT_EQ(model.walls, 7u);
  EXPECT_EQ(model.paired_walls, 1u);
  EXPECT_EQ(model.slabs, 4u);
  EXPECT_EQ(model.openings, 1u);
  EXPECT_EQ(count(model.text, "=IFCWALL("), 7u);
  EXPECT_EQ(count(model.text, "=IFCRELVOIDSELEMENT("), 1u);
  // 4 walls per room, the shared one twice, plus floor and ceiling.
  EXPECT_EQ(count(model.text, "=IFCRELSPACEBOUNDARY1STLEVEL("), 8u + 4u);
}

/** The lines of a file with an entity of a kind. */
std::vector<std::string>
linesOf(const std::string& text, const std::string& kind)
{
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (line.find("=" + kind + "(") != std::string::npos)
      lines.push_back(line.substr(line.find('=')));
  return lines;
}

TEST(WriteIfc, AStoreyLiesAtItsUsualFloor)
{
  Floorplan plan = joinedRooms();
  plan.rooms.push_back(roomBetween(rectangle(0, 3.2, 2, 4.2), -0.6, 2.5, 3)); // a pit
  for (PlanRoom& room : plan.rooms)
    room.floor.plane[3] -= 0.12345;
  const auto storeys = linesOf(writeIfc(plan).text, "IFCBUILDINGSTOREY");
  ASSERT_EQ(storeys.size(), 1u);
  EXPECT_EQ(count(storeys[0], ".ELEMENT.,0.123);"), 1u) << storeys[0];
}

TEST(WriteIfc, GuidsAreThoseOfProjectScanAndElement)
{
  const auto settings = [](const char* name, const char* scan) {
    IfcSettings s;
    s.name = name;
    s.scan = scan;
    return s;
  };
  Floorplan plan = joinedRooms();
  plan.openings.push_back(plan.openings[0]);
  plan.openings[1].kind = OpeningKind::Door;
  numberOpenings(plan);
  const auto projectOf = [&](const IfcSettings& s) {
    return linesOf(writeIfc(plan, s).text, "IFCPROJECT").at(0);
  };
  const std::string one = projectOf(settings("a", "1"));
  EXPECT_EQ(one, projectOf(settings("a", "1")));
  EXPECT_NE(one.substr(0, 40), projectOf(settings("b", "1")).substr(0, 40));
  EXPECT_NE(one, projectOf(settings("a", "2")));
  const std::string door = linesOf(writeIfc(plan).text, "IFCDOOR").at(0).substr(0, 34);
  plan.openings.erase(plan.openings.begin());
  EXPECT_EQ(linesOf(writeIfc(plan).text, "IFCDOOR").at(0).substr(0, 34), door)
      << "whatever is removed";
}

TEST(WriteIfc, TellsAuthorAndDateIfTheyAreGiven)
{
  IfcSettings settings;
  settings.author = "E. König";
  settings.date = "2024-05-31";
  EXPECT_EQ(count(writeIfc(joinedRooms(), settings).text,
                  "'2024-05-31T00:00:00',('E. K\\X2\\00F6\\X0\\nig')"),
            1u);
  settings.date = "in May"; // which IFC has no form for
  EXPECT_EQ(count(writeIfc(joinedRooms(), settings).text, "'1970-01-01T00:00:00'"), 1u);
}

TEST(WriteIfc, TellsOfEachElementWhetherItWasMeasured)
{
  Floorplan plan{{roomOf(rectangle(0, 0, 4, 3), 2.5)}}; // four walls and two slabs
  const auto numberOf = [&](const char* status) {
    return count(writeIfc(plan).text,
                 std::string("'Status',$,IFCLABEL('") + status + "')");
  };
  EXPECT_EQ(numberOf("inferred"), 6u);
  plan.rooms[0].floor.accuracy = {0.001, 0.004};
  plan.rooms[0].boundary.elements[0].accuracy = {0.001, 0.004};
  plan.rooms[0].details = {detailOf(rectangle(0, 1, 4, 1.3), 2.2)}; // a beam
  plan.rooms[0].details[0].slab.accuracy = {0.001, 0.004};
  EXPECT_EQ(numberOf("measured"), 3u);
  EXPECT_EQ(numberOf("inferred"), 4u);
}

TEST(WriteIfc, WallsAreExternalUnlessRoomsLieBehindThem)
{
  Floorplan plan = joinedRooms(); // 7 walls, one between the rooms
  const auto external = [&plan](const char* value) {
    return count(writeIfc(plan).text,
                 "'IsExternal',$,IFCBOOLEAN(" + std::string(value));
  };
  EXPECT_EQ(external(".T."), 6u);
  EXPECT_EQ(external(".F."), 1u);
  plan.rooms.push_back(roomOf(rectangle(0, 5, 8, 8), 2.5, 3)); // beyond a shaft of 2 m
  EXPECT_EQ(external(".F."), 1u + 2u + 1u);
  plan.openings.push_back(
      {OpeningKind::Window, {1, 0}, {{1, 2}}, {1, 3.1}, {2, 3.1}, 1, 2, 0, 0.2});
  EXPECT_EQ(external(".F."), 1u + 1u + 1u) << "a window leads out into it";
  const IfcModel model = writeIfc(plan);
  EXPECT_EQ(linesOf(model.text, "IFCWINDOWTYPE").size(), 1u);
  EXPECT_EQ(count(linesOf(model.text, "IFCWINDOW").at(0), ",'W1',1.,1.,"), 1u);
}

TEST(WriteIfc, WallsOfOneThicknessAreOfOneType)
{
  const IfcModel model =
      writeIfc(joinedRooms()); // 6 outer walls, one between the rooms
  const auto types = linesOf(model.text, "IFCWALLTYPE");
  ASSERT_EQ(types.size(), 2u);
  EXPECT_EQ(count(types[0] + types[1], "'Outer wall 0.20 assumed'"), 1u);
  EXPECT_EQ(count(types[0] + types[1], "'Wall 0.10'"), 1u);
  EXPECT_EQ(count(model.text, "'Reference',$,IFCIDENTIFIER('Outer wall 0.20 assumed')"),
            6u);
  const auto relations = linesOf(model.text, "IFCRELDEFINESBYTYPE");
  ASSERT_EQ(relations.size(), 2u);
  EXPECT_EQ(count(relations[0], "#"), 6u + 1u) << "walls and type";
}

TEST(WriteIfc, AStairHasItsFlights)
{
  Floorplan plan = joinedRooms();
  PlanFlight flight;
  flight.rise = 0.18;
  for (const double x : {0.5, 0.75, 1.0, 1.25})
    flight.risers.push_back({Eigen::Vector2d(x, 1), Eigen::Vector2d(x, 0)});
  plan.stairs = {{{1, 1}, {1, 1}, 0, 0.72, {flight, flight}}};
  const IfcModel model = writeIfc(plan);
  EXPECT_EQ(model.stairs, 1u);
  EXPECT_EQ(count(model.text, "=IFCSTAIR("), 1u);
  EXPECT_EQ(count(model.text, "=IFCSTAIRFLIGHT("), 2u);
  EXPECT_EQ(count(model.text, "$,4,3,0.18,0.25,.STRAIGHT.)"), 2u);
}

TEST(WriteIfc, AFaceTowardsTheRoofOfTheRoomBelowIsOfNoWall)
{
  Floorplan plan{{roomOf(rectangle(0, 0, 6, 4), 2.5),
                  roomBetween(rectangle(0, 0, 4, 4), 2.7, 5.2, 2)}};
  const std::size_t walls = writeIfc(plan).walls;
  plan.rooms[0].details = {detailOf(rectangle(4, 0, 6, 4), 5)}; // beside the upper room
  EXPECT_EQ(writeIfc(plan).walls, walls - 1);
}

TEST(WriteIfc, AFloorOverTwoRoomsIsAsThickAsTheGapThoughItsMiddleIsAboveAWall)
{
  Floorplan plan{{roomOf(rectangle(0, 0, 4, 3), 2.5),
                  roomOf(rectangle(4.1, 0, 8.1, 3), 2.5, 2),
                  roomBetween(rectangle(0, 0, 8.1, 3), 2.65, 5.2, 3)}};
  const IfcModel model = writeIfc(plan);
  EXPECT_EQ(model.slabs, 4u) << "three floors and one roof";
  EXPECT_EQ(count(model.text, ".ROOF.)"), 1u);
  EXPECT_EQ(count(model.text, "IFCPROPERTYSINGLEVALUE('ThicknessAssumed',$,"
                              "IFCBOOLEAN(.F.),$)"),
            2u)
      << "of the upper floor and of the partition";
  EXPECT_EQ(count(model.text, "=IFCRELSPACEBOUNDARY1STLEVEL("), 3u * 4 + 3 + 3);
}

TEST(WriteIfc, AWallAboveALowerRoofStandsOnIt)
{
  Floorplan plan{{roomOf(rectangle(0, 0, 6, 4), 2.5),
                  roomBetween(rectangle(0, 0, 4, 4), 2.7, 5.2, 2)}};
  const std::size_t walls = writeIfc(plan).walls;
  PlanDetail roof = detailOf(rectangle(4, 0, 6, 4), 0); // beside the upper room
  roof.is_facet = true;
  for (const double rise : {0.0, 0.5}) { // level, or rising along the wall
    roof.slab = slabAt(3.6 - 2 * rise, 0, rise);
    plan.rooms[0].details = {roof};
    const IfcModel model = writeIfc(plan);
    EXPECT_EQ(model.walls, walls) << rise;
    EXPECT_EQ(count(model.text, "IFCQUANTITYLENGTH('Height',$,$,1.6,$)"), 1u) << rise;
  }
}

TEST(WriteIfc, NoWallStandsAroundAShaftThatIsOpenToTheRoof)
{
  Floorplan plan{{roomOf(rectangle(0, 0, 9, 6), 2.5),
                  roomBetween(rectangle(0, 0, 9, 6), 2.7, 5.2, 2)}};
  const std::size_t walls = writeIfc(plan).walls;
  plan.rooms[1].columns = {reversed(rectangle(3, 2, 6, 4))};
  EXPECT_EQ(writeIfc(plan).walls, walls + 4); // nothing is known of the shaft
  plan.rooms[0].details = {detailOf(rectangle(3, 2, 6, 4), 5.2)};
  EXPECT_EQ(writeIfc(plan).walls, walls);
}

TEST(WriteIfc, AnOpeningWithoutAWallIsTold)
{
  Floorplan plan = joinedRooms();
  plan.openings[0].start = {20, 1};
  plan.openings[0].end = {20, 2};
  const IfcModel model = writeIfc(plan);
  EXPECT_EQ(model.openings, 0u);
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_EQ(model.warnings[0].kind, WarningKind::NotInIfc);
  EXPECT_EQ(model.warnings[0].reason, "P1");
}

TEST(WriteIfc, FacesThatLieInAnotherRoomAreToldAsTheyHaveNoWall)
{
  Floorplan plan = joinedRooms();
  plan.openings.clear();
  plan.rooms[1].boundary = rectangle(3.99, 0, 8, 3);
  const IfcModel model = writeIfc(plan);
  ASSERT_EQ(model.warnings.size(), 2u);
  EXPECT_EQ(model.warnings[0].kind, WarningKind::IfcLoss);
  EXPECT_EQ(model.warnings[0].reason,
            "no wall in the IFC for 1.2: there the room overlaps another one");
  EXPECT_EQ(model.warnings[1].room, 2u);
}

TEST(WriteIfc, RoomsThatTouchAtAPassageEndAtAVirtualElement)
{
  Floorplan plan = joinedRooms();
  plan.rooms[1].boundary = rectangle(4.005, 0, 8, 3);
  const IfcModel model = writeIfc(plan);
  EXPECT_TRUE(model.warnings.empty());
  EXPECT_EQ(model.openings, 0u);
  EXPECT_EQ(count(model.text, "=IFCVIRTUALELEMENT("), 1u);
  EXPECT_EQ(count(model.text, ",.VIRTUAL.,.INTERNAL."), 2u);
}

TEST(WriteIfc, ASliverBesideAPassageIsNoWall)
{
  for (const double beyond : {0.1, 0.14, 0.2}) { // the walls around end at 0.2 m
    Floorplan plan = joinedRooms();
    plan.openings[0].start.y() = -beyond;
    plan.openings[0].end.y() = 3 + beyond;
    plan.openings[0].top = 2.5;
    EXPECT_EQ(writeIfc(plan).walls, beyond > 0.1 ? 6u : 7u) << beyond;
  }
}

TEST(WriteIfc, TheOriginIsAMapConversion)
{
  EXPECT_EQ(count(writeIfc(joinedRooms()).text, "IFCMAPCONVERSION"), 0u);
  IfcSettings settings;
  settings.crs = "EPSG:25832";
  const std::string text =
      writeIfc(joinedRooms(), settings, Origin{{691600, 5335900.5, 512}}).text;
  EXPECT_EQ(count(text, "691600.,5335900.5,512.,1.,0.,1.);"), 1u);
  EXPECT_EQ(count(text, "IFCPROJECTEDCRS('EPSG:25832',"), 1u);
}

TEST(WriteIfc, BelowARoofWallsAreTriangles)
{
  Floorplan plan{{roomOf(rectangle(0, 0, 4, 3), 2.5)}};
  EXPECT_EQ(count(writeIfc(plan).text, "IFCTRIANGULATEDFACESET"), 0u);
  plan.rooms[0].ceiling = slabAt(2.5, 0.3, 0);
  // The space, the ceiling slab and the two walls whose tops slope.
  EXPECT_EQ(count(writeIfc(plan).text, "=IFCTRIANGULATEDFACESET("), 4u);
}

TEST(WriteIfc, ArcsAreAQuarterOfACircleAtMost)
{
  const std::string text = writeIfc({{roomOf(circle({0, 0}, 3), 2.5)}}).text;
  EXPECT_GT(count(text, "=IFCINDEXEDPOLYCURVE("), 0u);
  EXPECT_EQ(count(text, "IFCARCINDEX("), 4 * count(text, "=IFCINDEXEDPOLYCURVE("));
}

} // namespace

// SPDX-License-Identifier: BSD-3-Clause
#include "two_storeys.h"

#include <pcl/sedr_filters/floorplan_io.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <string>
#include <utility>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** A plan with all kinds of parts, whose numbers have no short decimal form. */
Floorplan
samplePlan()
{
  Floorplan plan;
  PlanRoom room = roomOf(placed(bittenRectangle(6, 4, 1), 10, {1e4 / 3, -0.1}), 2.5, 3);
  room.boundary.elements[0].inliers = 123456789;
  room.boundary.elements[0].residual = 1.0 / 3;
  room.boundary.elements[0].evidence = {1.0 / 7, 0.5, 5.0 / 14};
  room.boundary.elements[0].accuracy = {1.0 / 3000, 0.1 / 7};
  room.floor.accuracy = {0.1 / 300, 1.0 / 70};
  room.floor.plane = Eigen::Vector4d(1e-300, -1.0 / 7, std::sqrt(1 - 1.0 / 49), -0.1);
  room.floor.inliers = 17;
  room.floor.residual = 0.1 + 0.2;
  room.columns = {reversed(circle({M_PI, M_E}, 0.2)), reversed(rectangle(1, 1, 2, 2))};
  room.details = {detailOf(stadium(2, 0.3), 2.2), detailOf(rectangle(0, 0, 1, 1), 2.7)};
  room.details[0].holes = {reversed(circle({1, 0}, 0.1)),
                           reversed(rectangle(0, 0, 0.1, 0.1))};
  room.floor_details = {detailOf(rectangle(1, 1, 2, 1 + M_E), 0.1 / 3)};
  room.niches = {{stadium(1, 0.1 / 3), slabAt(0.1), slabAt(2.0 / 3)}};
  room.niches[0].bottom.curve = std::make_shared<SlabCurve>();
  room.floor_details[0].slab.curve = room.niches[0].bottom.curve;
  plan.rooms.push_back(room);
  plan.rooms.push_back(
      roomOf(rectangle(-1.0 / 3, 5e-324, 0.1, 1.0 / 7), 3, 4294967295u));
  plan.storeys = {{1, "ground \"floor\"", 0, 2.5, {3}},
                  {3, "attic", 2.8, 5.2, {4294967295u}}};
  plan.stairs = {{{3, 4294967295u}, {M_PI, 1.5}, 0, 2.8}};
  PlanFlight flight; // 4 steps along x, 1 m wide
  flight.bottom = 0.1;
  flight.rise = 0.175;
  for (const double x : {5.0, 5.25, 5.5, 5.75})
    flight.risers.push_back({Eigen::Vector2d(x, 1), Eigen::Vector2d(x, 0)});
  plan.stairs[0].flights = {flight};
  plan.openings = {ajarDoor()};
  return plan;
}

std::string
problemOf(const std::string& text)
{
  std::string problem = "none yet";
  EXPECT_TRUE(floorplanFromJson(text, problem).rooms.empty()) << text;
  return problem;
}

TEST(FloorplanJson, ReadsBackExactly)
{
  const Floorplan plan = samplePlan();
  std::string problem = "none yet";
  const Floorplan read = floorplanFromJson(floorplanToJson(plan), problem);
  EXPECT_EQ(problem, "");
  ASSERT_EQ(read.rooms.size(), 2u);
  const PlanRoom& room = read.rooms[0];
  const PlanElement& wall = room.boundary.elements[0];
  EXPECT_EQ(wall.inliers, 123456789u);
  EXPECT_EQ(wall.residual, 1.0 / 3);
  EXPECT_EQ(wall.evidence.hidden, 0.5);
  EXPECT_EQ(wall.accuracy.standard_error, 1.0 / 3000);
  EXPECT_EQ(wall.accuracy.deviation_95, 0.1 / 7);
  EXPECT_EQ(room.floor.accuracy.standard_error, 0.1 / 300);
  EXPECT_EQ(room.floor.accuracy.deviation_95, 1.0 / 70);
  EXPECT_FALSE(room.ceiling.accuracy.isKnown());
  EXPECT_FALSE(room.boundary.elements[1].accuracy.isKnown());
  EXPECT_EQ(room.floor.plane, plan.rooms[0].floor.plane);
  EXPECT_EQ(room.columns[0].elements[0].centre, Eigen::Vector2d(M_PI, M_E));
  EXPECT_EQ(room.details[0].holes.size(), 2u);
  EXPECT_EQ(room.floor_details[0].slab.plane,
            plan.rooms[0].floor_details[0].slab.plane);
  EXPECT_EQ(room.niches[0].top.plane, plan.rooms[0].niches[0].top.plane);
  EXPECT_TRUE(room.niches[0].bottom.curve && room.floor_details[0].slab.curve);
  EXPECT_FALSE(room.niches[0].top.curve);
  ASSERT_EQ(read.storeys.size(), 2u);
  EXPECT_EQ(read.storeys[0].name, "ground \"floor\"");
  EXPECT_EQ(read.storeys[1].number, 3u);
  EXPECT_EQ(read.storeys[1].rooms, (std::vector<std::uint32_t>{4294967295u}));
  ASSERT_EQ(read.stairs.size(), 1u);
  EXPECT_EQ(read.stairs[0].rooms, plan.stairs[0].rooms);
  EXPECT_EQ(read.stairs[0].at, plan.stairs[0].at);
  EXPECT_EQ(read.stairs[0].top, 2.8);
  ASSERT_EQ(read.stairs[0].flights.size(), 1u);
  const PlanFlight& flight = read.stairs[0].flights[0];
  EXPECT_EQ(flight.risers, plan.stairs[0].flights[0].risers);
  EXPECT_NEAR(flight.top(), 0.8, 1e-12);
  EXPECT_NEAR(flight.going(), 0.25, 1e-12);
  EXPECT_EQ(flight.outline().size(), 8u);
  ASSERT_EQ(read.openings.size(), 1u);
  const PlanOpening& door = read.openings[0];
  EXPECT_EQ(door.kind, OpeningKind::Door);
  EXPECT_EQ(door.rooms, plan.openings[0].rooms);
  ASSERT_EQ(door.walls.size(), 1u);
  EXPECT_EQ(door.walls[0].room, 3u);
  EXPECT_EQ(door.start, Eigen::Vector2d(1, -0.1));
  EXPECT_EQ(door.top + door.rise, 2.05 + 0.2);
  EXPECT_EQ(door.hinge, OpeningHinge::End);
  EXPECT_EQ(door.swing, 3u);
  EXPECT_EQ(door.state, OpeningState::Ajar);
  EXPECT_EQ(door.confidence, 0.9);
  EXPECT_EQ(door.residual + door.deviation_95, 0.003 + 0.007);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(door.edges[k].seen, plan.openings[0].edges[k].seen) << k;
    EXPECT_EQ(door.edges[k].error, plan.openings[0].edges[k].error) << k;
  }
  EXPECT_EQ(floorplanToJson(read), floorplanToJson(plan));
}

TEST(FloorplanJson, EdgesOfOpeningsAreFourOfKnownKinds)
{
  nlohmann::ordered_json json =
      nlohmann::ordered_json::parse(floorplanToJson(samplePlan()));
  nlohmann::ordered_json& edges = json["openings"][0]["edges"];
  const auto problemWith = [&](const nlohmann::ordered_json& other) {
    const nlohmann::ordered_json before = std::exchange(edges, other);
    const std::string problem = problemOf(json.dump());
    edges = before;
    return problem;
  };
  nlohmann::ordered_json other = edges;
  other.erase(3);
  EXPECT_NE(problemWith(other).find("an opening has 4 edges, not 3"),
            std::string::npos);
  EXPECT_NE(problemWith("all").find("an opening has 4 edges, not \"all\""),
            std::string::npos);
  other = edges;
  other.push_back(other[0]);
  EXPECT_NE(problemWith(other).find("an opening has 4 edges, not 5"),
            std::string::npos);
  other = edges;
  other[2]["seen"] = "glass";
  EXPECT_NE(problemWith(other).find("an edge of an opening is seen by nothing, leaf, "
                                    "rim or reveal, not by \"glass\""),
            std::string::npos)
      << problemWith(other);
}

TEST(PlanDocument, ReadsBackWhole)
{
  PlanDocument document{samplePlan(), Origin{{691600.1, 5335900 + 1.0 / 3, -12}},
                        Levelling::of({0.01, 0.02, 1}, {3, 4, 5}), 1.5};
  document.plan.rooms[0].name = "Küche \"2\"";
  std::string problem;
  const PlanDocument read = documentFromJson(documentToJson(document), problem);
  EXPECT_EQ(problem, "");
  EXPECT_EQ(read.origin, document.origin);
  ASSERT_TRUE(read.levelling);
  EXPECT_EQ(read.levelling->rotation, document.levelling->rotation);
  EXPECT_EQ(read.levelling->about, document.levelling->about);
  EXPECT_EQ(read.max_wall, 1.5);
  EXPECT_EQ(read.plan.rooms[0].name, document.plan.rooms[0].name);
  EXPECT_EQ(documentToJson(read), documentToJson(document));
}

TEST(PlanDocument, MayLackAllButThePlan)
{
  std::string problem;
  const PlanDocument read = documentFromJson(floorplanToJson(samplePlan()), problem);
  EXPECT_EQ(problem, "");
  EXPECT_TRUE(read.origin.isZero());
  EXPECT_FALSE(read.levelling);
  EXPECT_EQ(read.max_wall, Priors().max_wall);
}

TEST(PlanDocument, RefusesWhatIsNoOriginOrThickness)
{
  const auto problemWith = [](const std::string& member) {
    std::string text = floorplanToJson(samplePlan());
    const std::string key = member.substr(0, member.find(':'));
    if (const std::size_t at = text.find(key); at != std::string::npos)
      text.replace(at, text.find('\n', at) - at, member); // the last one
    else
      text.insert(1, member + ",");
    std::string problem;
    documentFromJson(text, problem);
    return problem;
  };
  const auto holds = [](const std::string& problem, const char* part) {
    return problem.find(part) != std::string::npos;
  };
  EXPECT_TRUE(holds(problemWith(R"("max_wall": 1e9)"),
                    "the prior max_wall must be from 0.1 to 3"));
  EXPECT_TRUE(holds(problemWith(R"("max_wall": "wide")"), "must be number"));
  EXPECT_TRUE(holds(problemWith(R"("levelling": {"rotation": 7})"), "cannot be read"));
}

TEST(FloorplanJson, TruncatedTextIsRefusedWhereverItEnds)
{
  const std::string text = floorplanToJson(samplePlan());
  for (std::size_t n = 0; n + 2 < text.size(); n += 7)
    ASSERT_NE(problemOf(text.substr(0, n)), "") << n << " of " << text.size();
}

} // namespace

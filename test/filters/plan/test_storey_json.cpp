// SPDX-License-Identifier: BSD-3-Clause
#include "two_storeys.h"

#include <pcl/sedr_filters/floorplan_io.h>

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

Floorplan
twoNamedStoreys()
{
  Floorplan plan = twoStoreys(1.0 / 3);
  plan.storeys = {{1, "ground \"floor\"", 0, 2.5, {1, 2}},
                  {3, "attic", 2.8, 5.2, {3, 4}}};
  plan.stairs = {{{2, 4}, {M_PI, 1.5}, 0, 2.8}};
  PlanFlight flight; // 4 steps along x, 1 m wide
  flight.bottom = 0.1;
  flight.rise = 0.175;
  for (const double x : {5.0, 5.25, 5.5, 5.75})
    flight.risers.push_back({Eigen::Vector2d(x, 1), Eigen::Vector2d(x, 0)});
  plan.stairs[0].flights = {flight};
  return plan;
}

Floorplan
readOf(const std::string& text, std::string& problem)
{
  problem = "none yet";
  return floorplanFromJson(text, problem);
}

TEST(StoreyJson, ReadsBackExactly)
{
  const Floorplan plan = twoNamedStoreys();
  std::string problem;
  const Floorplan read = readOf(floorplanToJson(plan), problem);
  EXPECT_EQ(problem, "");
  ASSERT_EQ(read.storeys.size(), 2u);
  EXPECT_EQ(read.storeys[0].name, "ground \"floor\"");
  EXPECT_EQ(read.storeys[1].number, 3u);
  EXPECT_EQ(read.storeys[1].rooms, (std::vector<std::uint32_t>{3, 4}));
  EXPECT_NEAR(read.storeys[1].floor, 2.8, 1e-12);
  EXPECT_NEAR(read.storeys[1].ceiling, 5.2, 1e-12);
  ASSERT_EQ(read.stairs.size(), 1u);
  EXPECT_EQ(read.stairs[0].rooms, plan.stairs[0].rooms);
  EXPECT_EQ(read.stairs[0].at, plan.stairs[0].at);
  EXPECT_EQ(read.stairs[0].top, 2.8);
  ASSERT_EQ(read.stairs[0].flights.size(), 1u);
  const PlanFlight& flight = read.stairs[0].flights[0];
  EXPECT_EQ(flight.risers, plan.stairs[0].flights[0].risers);
  EXPECT_EQ(flight.rise, 0.175);
  EXPECT_NEAR(flight.top(), 0.8, 1e-12);
  EXPECT_NEAR(flight.going(), 0.25, 1e-12);
  EXPECT_EQ(flight.outline().size(), 8u);
  EXPECT_EQ(floorplanToJson(read), floorplanToJson(plan));
}

TEST(StoreyJson, StairsWithinARoomAreThoseWithFlights)
{
  Floorplan plan = twoNamedStoreys();
  plan.stairs[0].rooms = {2, 2};
  std::string problem;
  EXPECT_EQ(readOf(floorplanToJson(plan), problem).stairs.size(), 1u) << problem;
  plan.stairs[0].flights.clear();
  EXPECT_TRUE(readOf(floorplanToJson(plan), problem).stairs.empty());
}

TEST(StoreyJson, ARoomThatIsGoneIsOutside)
{
  Floorplan plan = twoNamedStoreys();
  plan.rooms.erase(plan.rooms.begin(), plan.rooms.begin() + 2);
  std::string problem;
  const Floorplan read = readOf(floorplanToJson(plan), problem);
  EXPECT_EQ(problem, "");
  ASSERT_EQ(read.storeys.size(), 1u);
  EXPECT_EQ(read.storeys[0].name, "attic");
  ASSERT_EQ(read.stairs.size(), 1u);
  EXPECT_EQ(read.stairs[0].rooms[0], 0u);
  EXPECT_EQ(read.stairs[0].rooms[1], 4u);
}

} // namespace

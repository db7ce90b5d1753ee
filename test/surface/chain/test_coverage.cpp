// SPDX-License-Identifier: BSD-3-Clause
#include "building_of_two_rooms.h"
#include "says.h"

#include <gtest/gtest.h>
#include <pcl/sedr_surface/plan_review.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(Coverage, IsTheShareOfTheFloorThatWasSeenWhichThePlanHolds)
{
  const Floorplan whole{{planned(1, 0, 4), planned(2, 5, 7)}};
  const Floorplan one{{planned(2, 5, 7)}};
  const Floorplan part{{planned(1, 0, 2), planned(2, 5, 7)}};
  struct Case {
    Floorplan plan;
    std::vector<LeftOut> left_out;
    double modelled, seen; ///< square metres
    std::string largest;   ///< reason of what is missing most; empty: nothing is
  };
  for (const Case& c : std::vector<Case>{
           {whole, {}, 18, 18, ""},
           {one, {}, 6, 18, "room 1: no plan could be fitted"},
           {part, {}, 12, 18, "room 1: "},
           {whole,
            {{LeftOutKind::Low, "low", 30, 0, 1, {0, 9}},
             {LeftOutKind::Void, "voids", 50, 0, 0, {0, 0}}},
            18,
            18,
            ""}, // they have no headroom, or are no floor
           {whole, {{LeftOutKind::Open, "no walls", 11, 0, 2.5, {0, 9}}}, 18, 18, ""},
           {whole,
            {{LeftOutKind::Open, "no walls", 42, 0, 2.5, {0, 9}}},
            18,
            60,
            "no walls"}, // larger than all rooms, it is no glimpse
           {whole,
            {{LeftOutKind::Partial, "seen in part", 6, 0, 2.5, {0, 9}}},
            18,
            24,
            "seen in part"}}) {
    SCOPED_TRACE(c.largest + std::to_string(c.seen));
    Building building = buildingOfTwoRooms();
    building.left_out = c.left_out;
    const Coverage coverage = coverageOf(building, c.plan);
    const double edge_of_cells = c.modelled == 12 ? 0.7 : 1e-6;
    EXPECT_NEAR(coverage.modelled, c.modelled, edge_of_cells);
    EXPECT_NEAR(coverage.seen, c.seen, edge_of_cells);
    EXPECT_NEAR(coverage.share(), coverage.modelled / coverage.seen, 1e-6);
    ASSERT_EQ(coverage.largest() != nullptr, !c.largest.empty());
    ASSERT_EQ(coverageWarning(coverage).has_value(), !c.largest.empty());
    if (c.largest.empty())
      continue;
    EXPECT_EQ(coverage.largest()->reason.find(c.largest), 0u);
    EXPECT_TRUE(says(sentenceOf(*coverageWarning(coverage)), c.largest));
  }
  Building building = buildingOfTwoRooms();
  building.left_out = {{LeftOutKind::Low, "low", 30, 0, 1, {0, 9}}};
  EXPECT_EQ(coverageOf(building, whole).not_counted, 30);
  const std::string told =
      sentenceOf(*coverageWarning(coverageOf(buildingOfTwoRooms(), one)));
  EXPECT_TRUE(says(told, "6 of the 18 m2", "12 m2 around (0.1, 1.6)"));
}

} // namespace

// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/rooms/storey_levels.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;

constexpr double step = 1.6;

/** Rooms of 10 square metres each with these floors and ceilings. */
std::vector<BuildingRoom>
roomsBetween(const std::vector<std::pair<double, double>>& heights)
{
  std::vector<BuildingRoom> rooms(heights.size());
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    rooms[r].id = static_cast<std::uint32_t>(r + 1);
    rooms[r].floor = heights[r].first;
    rooms[r].ceiling = heights[r].second;
    rooms[r].area = 10;
  }
  return rooms;
}

using Ids = std::vector<std::uint32_t>;

TEST(FindStoreys, OfRoomsAboveRoomsAreNumberedFromTheLowestUp)
{
  auto rooms =
      roomsBetween({{2.8, 5.3}, {0, 2.5}, {-2.9, -0.3}, {2.85, 5.2}, {0, 2.6}});
  const std::vector<PlanStorey> storeys = findStoreys(rooms, step);
  ASSERT_EQ(storeys.size(), 3u);
  EXPECT_EQ(storeys[0].rooms, (Ids{3}));
  EXPECT_EQ(storeys[1].rooms, (Ids{2, 5}));
  EXPECT_EQ(storeys[2].rooms, (Ids{1, 4}));
  for (std::size_t s = 0; s < 3; ++s) {
    EXPECT_EQ(storeys[s].number, s + 1);
    EXPECT_FALSE(storeys[s].name.empty());
    for (const std::uint32_t id : storeys[s].rooms)
      EXPECT_EQ(rooms[id - 1].storey, s + 1);
  }
  EXPECT_EQ(storeys[1].floor, 0);
  EXPECT_EQ(storeys[1].ceiling, 2.6);
  EXPECT_EQ(storeys[2].floor, 2.8);
}

TEST(FindStoreys, ASplitLevelOfHalfAMetreIsOne)
{
  auto rooms = roomsBetween({{0, 2.5}, {0.5, 3}, {1, 3.5}});
  EXPECT_EQ(findStoreys(rooms, step).size(), 1u);
  EXPECT_EQ(findStoreys(rooms, 0.4).size(), 3u);
}

TEST(FindStoreys, AHallOfTwoIsOfTheLowerOne)
{
  auto rooms = roomsBetween({{0, 5.3}, {0, 2.5}, {2.8, 5.3}});
  const std::vector<PlanStorey> storeys = findStoreys(rooms, step);
  ASSERT_EQ(storeys.size(), 2u);
  EXPECT_EQ(storeys[0].rooms, (Ids{1, 2}));
  EXPECT_EQ(storeys[0].ceiling, 5.3);
  EXPECT_EQ(storeys[1].rooms, (Ids{3}));
}

TEST(FindStoreys, OfNoRoomsThereAreNone)
{
  std::vector<BuildingRoom> rooms;
  EXPECT_TRUE(findStoreys(rooms, step).empty());
}

} // namespace

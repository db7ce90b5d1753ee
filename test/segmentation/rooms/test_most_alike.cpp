// SPDX-License-Identifier: BSD-3-Clause
#include "building_scene.h"

#include "sedr_segmentation/src/rooms/most_alike.h"

#include <gtest/gtest.h>

#include <string>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** Rooms of points, a digit each. */
std::vector<std::uint32_t>
roomsOf(const std::string& digits)
{
  std::vector<std::uint32_t> rooms;
  for (const char digit : digits)
    rooms.push_back(static_cast<std::uint32_t>(digit - '0'));
  return rooms;
}

TEST(Likeness, IsOneForTheSameRoomsWhateverTheirNumbers)
{
  EXPECT_DOUBLE_EQ(likeness(roomsOf("1112220"), roomsOf("2221110")), 1);
  EXPECT_DOUBLE_EQ(likeness(roomsOf("1113330"), roomsOf("2221110")), 1) << "no room 2";
}

TEST(Likeness, CountsTheRoomsThatOverlapByMoreThanHalf)
{
  // 4 of 5 points, and 3 of 3; then one room against its halves; then 3 of 4 and none.
  EXPECT_DOUBLE_EQ(likeness(roomsOf("11111222"), roomsOf("11110222")), 1);
  EXPECT_DOUBLE_EQ(likeness(roomsOf("11111111"), roomsOf("11112222")), 0);
  EXPECT_DOUBLE_EQ(likeness(roomsOf("11112222"), roomsOf("11100000")), 2.0 / (2 + 1));
}

TEST(Likeness, IsTheSameBothWays)
{
  const auto a = roomsOf("1111222230");
  const auto b = roomsOf("1110222211");
  EXPECT_DOUBLE_EQ(likeness(a, b), likeness(b, a));
  EXPECT_GT(likeness(a, b), 0);
  EXPECT_LT(likeness(a, b), 1);
}

TEST(Likeness, OfNoRoomsIsNone)
{
  EXPECT_EQ(likeness({}, {}), 0);
  EXPECT_EQ(likeness(roomsOf("000"), roomsOf("000")), 0);
  EXPECT_EQ(likeness(roomsOf("000"), roomsOf("111")), 0);
}

/** Buildings of which only the rooms of points are known. */
std::vector<Building>
buildingsOf(const std::vector<std::string>& rooms)
{
  std::vector<Building> buildings(rooms.size());
  for (std::size_t k = 0; k < rooms.size(); ++k)
    buildings[k].room_of = roomsOf(rooms[k]);
  return buildings;
}

TEST(MostAlike, IsWhatMostAgreeOn)
{
  EXPECT_EQ(mostAlike(buildingsOf({"11111111", "11112222", "11112220"})), 1u);
  EXPECT_EQ(mostAlike(buildingsOf({"11112222", "11111111", "11111111"})), 1u);
}

TEST(MostAlike, IsTheFirstOfEqualOnesAndNeverOneWithoutRooms)
{
  EXPECT_EQ(mostAlike(buildingsOf({"1122", "2211", "1122"})), 0u);
  EXPECT_EQ(mostAlike(buildingsOf({"0000", "0000", "1111", "0000"})), 2u);
  EXPECT_EQ(mostAlike(buildingsOf({"0000", "0000"})), 0u);
  EXPECT_EQ(mostAlike({}), 0u);
}

} // namespace

// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/rooms/agreed_rooms.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace {

using namespace pcl::sedr;

/** The rooms of places, a digit each, '.' for none, and back with digits by their first
 * place. */
std::string
agreed(const std::vector<std::string>& partitions)
{
  std::vector<std::vector<std::int32_t>> rooms;
  for (const std::string& digits : partitions) {
    rooms.emplace_back();
    for (const char digit : digits)
      rooms.back().push_back(digit == '.' ? -1 : digit - '0');
  }
  std::map<std::int32_t, char> digit_of{{-1, '.'}};
  std::string digits;
  for (const std::int32_t room : agreedRooms(rooms))
    digits +=
        digit_of.emplace(room, static_cast<char>('0' + digit_of.size())).first->second;
  return digits;
}

TEST(AgreedRooms, AreThoseOfMostPartitionsPlaceByPlace)
{
  // Each partition is wrong in one place, and each in another.
  EXPECT_EQ(agreed({"11223344", "11112233", "22334444", "11223344"}), "11223344");
  EXPECT_EQ(agreed({"11111122", "55566677", "33344455"}), "11122233");
}

TEST(AgreedRooms, OfEquallyManyVotesTheFirstDecides)
{
  EXPECT_EQ(agreed({"1122", "1122", "1111", "1111"}), "1122");
  EXPECT_EQ(agreed({"1111", "1111", "1122", "1122"}), "1111");
  EXPECT_EQ(agreed({"1111", "1122", "1122", "1122"}), "1122");
}

TEST(AgreedRooms, PlacesAtABorderGoToTheRoomThatMostSee)
{
  EXPECT_EQ(agreed({"11112222", "11111222", "11111222", "11111222"}), "11111222");
}

TEST(AgreedRooms, WhereAPartitionHasNoRoomItHasNoVote)
{
  EXPECT_EQ(agreed({"111.222.", "11112222", "1.1.2.2.", "11112222"}), "11112222");
  EXPECT_EQ(agreed({"11.", "11.", "22."}), "11.");
}

TEST(AgreedRooms, AreJoinedWhereTheyAgreeMostFirst)
{
  // 1 and 2 are one in four partitions of five, 2 and 3 in three, 1 and 3 in two.
  EXPECT_EQ(agreed({"112233", "111122", "111111", "111111", "111122"}), "111122");
}

TEST(AgreedRooms, OfOneOrNoneAreTheSame)
{
  EXPECT_EQ(agreed({"1123.1"}), "1123.1");
  EXPECT_EQ(agreed({}), "");
  EXPECT_EQ(agreed({"", ""}), "");
  EXPECT_EQ(agreed({"...", "..."}), "...");
}

} // namespace

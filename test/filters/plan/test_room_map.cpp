// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/plan/room_map.h"

#include <gtest/gtest.h>

#include <limits>

namespace {

TEST(RoomMap, CellsTakeTheRoomOfMostCeilingPointsAndDetailsThatOfTheCeilingBeside)
{
  // Cells of 1 m along x: ceiling of room 1 at 0 and 1, of room 2 at 5; detail at 2, 3
  // and 9. Cell 1 contains a point of room 2 and two of room 1.
  std::vector<float> x;
  std::vector<std::uint32_t> room;
  pcl::Indices ceiling;
  pcl::Indices detail;
  const auto add = [&](float at, std::uint32_t in_room, pcl::Indices* to) {
    if (to)
      to->push_back(static_cast<int>(room.size()));
    x.insert(x.end(), {at, 0.5f, 2.f});
    room.push_back(in_room);
    return static_cast<int>(room.size()) - 1;
  };
  add(0.5f, 1, &ceiling);
  add(1.2f, 2, &ceiling);
  add(1.5f, 1, &ceiling);
  add(1.7f, 1, &ceiling);
  add(5.5f, 2, &ceiling);
  const int beside = add(2.5f, 0, &detail);
  const int further = add(3.5f, 0, &detail);
  const int alone = add(9.5f, 0, &detail);
  const int below = add(1.3f, 0, nullptr);
  const int outside = add(7.5f, 0, nullptr);
  const int lost = add(std::numeric_limits<float>::quiet_NaN(), 0, nullptr);
  const pcl::sedr::PointView points(x.data(), 3 * sizeof(float), room.size());
  const pcl::sedr::RoomMap map(pcl::sedr::CellGrid(1), points, room, ceiling, detail);
  EXPECT_EQ(map.roomOver(0), 1u);
  EXPECT_EQ(map.roomOver(4), 2u);
  EXPECT_EQ(map.roomOver(beside), 1u);
  EXPECT_EQ(map.roomOver(further), 1u);
  EXPECT_EQ(map.roomOver(alone), 0u);
  EXPECT_EQ(map.roomOver(below), 1u);
  EXPECT_EQ(map.roomOver(outside), 0u);
  EXPECT_EQ(map.roomOver(lost), 0u);
}

} // namespace

// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/outliers/region_selection.h"
#include "sedr_filters/src/plan/room_map.h"

#include <gtest/gtest.h>

#include <random>

namespace {

using pcl::sedr::Cell;
using pcl::sedr::CellSet;

using Sizes = std::vector<std::size_t>;

/** The cells [x0, x1) x [y0, y1). */
void
addBlock(std::vector<pcl::sedr::CellKey>& keys, int x0, int x1, int y0, int y1)
{
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x)
      keys.push_back(pcl::sedr::keyOf({x, y}));
}

TEST(LabelOpenedRegions, HolesInThinDataPartNothingButAPartitionStillDoes)
{
  // Two rooms of 60 x 60 cells with random holes and a partition of two cells with
  // noise.
  struct Case {
    int radius;
    unsigned holes; // percent
  };
  for (const auto& [radius, holes] :
       {Case{1, 0}, Case{1, 10}, Case{2, 0}, Case{2, 5}, Case{3, 0}, Case{3, 2}})
    for (unsigned seed = 0; seed < 20; ++seed) {
      std::mt19937 random(seed);
      std::vector<pcl::sedr::CellKey> keys;
      for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 122; ++x) {
          const bool is_partition = x == 60 || x == 61;
          if (random() % 100 < (is_partition ? 5 : 100 - holes))
            keys.push_back(pcl::sedr::keyOf({x, y}));
        }
      addBlock(keys, 5, 6, 20, 21);
      addBlock(keys, 60, 62, 20, 21);
      addBlock(keys, 115, 116, 20, 21);
      const CellSet cells(keys);
      const auto regions = pcl::sedr::labelOpenedRegions(cells, radius, 400);
      auto sizes = regions.sizes;
      sizes.resize(3, 0);
      EXPECT_LT(sizes[2], 50u) << "radius " << radius << ", " << holes << " %";
      EXPECT_GT(sizes[1], cells.size() / 3);
      EXPECT_NE(regions.label[cells.find({5, 20})],
                regions.label[cells.find({115, 20})])
          << "radius " << radius << ", " << holes << " %";
    }
}

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

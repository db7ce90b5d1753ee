// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/grids/cell_count.h"
#include "sedr_segmentation/src/plan/box_clusters.h"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace pcl::sedr;

TEST(CellsFor, RoundsALengthToWholeCellsAtLeastSoMany)
{
  EXPECT_EQ(cellsFor(0.4, 0.05), 8);
  EXPECT_EQ(cellsFor(0.12, 0.05), 2);
  EXPECT_EQ(cellsFor(0.13, 0.05), 3);
  EXPECT_EQ(cellsFor(0.01, 0.05), 1);
  EXPECT_EQ(cellsFor(0.01, 0.05, 3), 3);
}

bool
operator==(const CellBox& a, const CellBox& b)
{
  return a.low == b.low && a.high == b.high;
}

TEST(ClusterBoxes, KeepApartWhatIsFarApart)
{
  const auto clusters = clusterBoxes({{{0, 0}, {9, 9}}, {{200000, 0}, {200009, 9}}}, 3);
  ASSERT_EQ(clusters.size(), 2u);
  EXPECT_TRUE(clusters[0] == (CellBox{{-3, -3}, {12, 12}}));
  EXPECT_TRUE(clusters[1] == (CellBox{{199997, -3}, {200012, 12}}));
}

TEST(ClusterBoxes, JoinWhatTheirMarginsMakeOverlap)
{
  EXPECT_EQ(clusterBoxes({{{0, 0}, {9, 9}}, {{15, 0}, {20, 9}}}, 3).size(), 1u);
  EXPECT_EQ(clusterBoxes({{{0, 0}, {9, 9}}, {{16, 0}, {20, 9}}}, 3).size(), 2u);
  EXPECT_TRUE(clusterBoxes({{{0, 0}, {9, 9}}, {{15, 4}, {20, 30}}}, 3)[0] ==
              (CellBox{{-3, -3}, {23, 33}}));
}

TEST(ClusterBoxes, LeaveNoOverlapHoweverTheBoxesLie)
{
  std::mt19937 random(12);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<CellBox> boxes;
    for (int k = 0; k < 12; ++k) {
      const Cell low{static_cast<int>(random() % 100),
                     static_cast<int>(random() % 100)};
      boxes.push_back({low,
                       {low.x + static_cast<int>(random() % 15),
                        low.y + static_cast<int>(random() % 15)}});
    }
    const auto clusters = clusterBoxes(boxes, 2);
    const auto isIn = [](const CellBox& a, const CellBox& b) {
      return a.low.x >= b.low.x && a.low.y >= b.low.y && a.high.x <= b.high.x &&
             a.high.y <= b.high.y;
    };
    for (const auto& b : boxes)
      EXPECT_EQ(std::count_if(clusters.begin(), clusters.end(),
                              [&](const auto& c) { return isIn(grown(b, 2), c); }),
                1);
    for (std::size_t i = 0; i < clusters.size(); ++i)
      for (std::size_t j = i + 1; j < clusters.size(); ++j)
        EXPECT_TRUE(clusters[i].high.x < clusters[j].low.x ||
                    clusters[j].high.x < clusters[i].low.x ||
                    clusters[i].high.y < clusters[j].low.y ||
                    clusters[j].high.y < clusters[i].low.y);
  }
}

TEST(ClusterBoxes, OfEmptyBoxesAreNone)
{
  EXPECT_TRUE(clusterBoxes({}, 3).empty());
  EXPECT_TRUE(clusterBoxes({{{0, 0}, {-1, -1}}}, 3).empty());
}

} // namespace

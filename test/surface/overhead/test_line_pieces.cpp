// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include "sedr_surface/src/overhead/line_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(LinePieces, HaveNoBulgesThatAreTooSmall)
{
  // A tooth of 20 by 10 cm, and a step of 20 cm that goes on.
  const std::vector<PlanElement> line =
      polygon({{0, 0}, {2, 0}, {2.1, 0.2}, {2.2, 0}, {5, 0}, {5, 0.2}, {9, 0.2}})
          .elements;
  const std::vector<PlanElement> open(line.begin(), line.end() - 1);
  EXPECT_EQ(withoutBulges(open, 0.01).size(), 6u);
  const auto kept = withoutBulges(open, 0.05);
  ASSERT_EQ(kept.size(), 3u);
  EXPECT_EQ(kept[0].end, Eigen::Vector2d(5, 0));
  EXPECT_EQ(kept[2].end, Eigen::Vector2d(9, 0.2));
}

TEST(LinePieces, AnOctagonHasCorners)
{
  for (const int places : {1, 10})
    for (const double radius : {0.5, 1.5}) {
      Corners line;
      for (int k = 0; k < 8; ++k)
        for (int i = 0; i < places; ++i) {
          const auto corner = [&](int c) {
            return Eigen::Vector2d(radius * std::cos(c * M_PI / 4),
                                   radius * std::sin(c * M_PI / 4));
          };
          line.push_back(corner(k) + double(i) / places * (corner(k + 1) - corner(k)));
        }
      line.push_back(line.front());
      const auto pieces = piecesOf(line, 0.05);
      EXPECT_EQ(pieces.size(), 8u);
      for (const PlanElement& piece : pieces)
        EXPECT_FALSE(piece.isArc());
    }
}

TEST(LinePieces, AreFew)
{
  // Teeth of 2 cm along 4 m, then a corner.
  Corners line;
  for (int k = 0; k <= 40; ++k)
    line.emplace_back(0.1 * k, k % 2 == 0 ? 0 : 0.02);
  line.emplace_back(4, 2);
  EXPECT_EQ(piecesOf(line, 0.03).size(), 2u);
  EXPECT_GT(piecesOf(line, 0.01).size(), 20u);
  EXPECT_EQ(piecesOf(line, 0.03)[1].end, Eigen::Vector2d(4, 2));
  EXPECT_TRUE(piecesOf({}, 0.01).empty());
}

TEST(LinePieces, AnArcIsOne)
{
  Corners line;
  for (int k = 0; k <= 30; ++k)
    line.emplace_back(2 * std::cos(k * M_PI / 60), 2 * std::sin(k * M_PI / 60));
  const auto pieces = piecesOf(line, 0.03);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_NEAR(pieces[0].length(), M_PI, 1e-6);
  EXPECT_TRUE(pieces[0].counter_clockwise);
  // There and back again on the same arc is none.
  for (int k = 30; k > 0; --k)
    line.push_back(line[static_cast<std::size_t>(k)]);
  for (const PlanElement& piece : piecesOf(line, 0.03))
    EXPECT_LT(piece.length(), M_PI + 0.1);
}

} // namespace

// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/arrangement/label_loops.h"
#include "sedr_segmentation/src/arrangement/plan_cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

namespace {

using namespace pcl::sedr;

TEST(LabelLoops, RoomsThatTouchAtACornerAreSimple)
{
  std::vector<PlanDivider> dividers;
  std::vector<PlanCurve> curves;
  for (const double k : {1, 5, 9})
    for (const Eigen::Vector2d& along :
         {Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1)}) {
      const Eigen::Vector2d start = k * Eigen::Vector2d(along.y(), along.x());
      dividers.push_back(
          {start, start + 10 * along, static_cast<std::uint32_t>(curves.size())});
      curves.push_back(lineThrough(start, start + along));
    }
  const PlanCells cells({Eigen::Vector2d(0, 0), Eigen::Vector2d(10, 10)}, dividers);
  std::vector<int> labels;
  for (const PlanCells::Polygon& cell : cells.polygons()) {
    const Eigen::Vector2d p =
        std::accumulate(cell.begin(), cell.end(), Eigen::Vector2d(0, 0)) /
        static_cast<double>(cell.size());
    const bool is_outside = p.minCoeff() < 1 || p.maxCoeff() > 9;
    labels.push_back(is_outside ? 0 : (p.x() < 5) == (p.y() < 5) ? 1 : 2);
  }
  for (const int label : {1, 2}) {
    const PlanLoop loop = labelLoops(cells.borders(), labels, label, curves).outer;
    EXPECT_EQ(loop.elements.size(), 4U) << label;
    EXPECT_NEAR(loop.area(), 16, 1e-9) << label;
  }
}

TEST(LabelLoops, ASliverBetweenAnArcAndItsChordIsNoColumn)
{
  // 0.8 m long on a circle of 3 m, 2.7 cm wide, in the middle of a square.
  const Eigen::Vector2d a(-0.4, std::sqrt(9 - 0.16) - 3), top(0, 0), b(0.4, a.y());
  PlanCurve circle;
  circle.point = {0, -3};
  circle.radius = 3;
  std::vector<PlanCurve> curves{circle, lineThrough(b, a)};
  std::vector<CellBorder> borders{{0, a, top, 1, 2},
                                  {0, top, b, 1, 2},
                                  {1, b, a, 1, 2}};
  const Eigen::Vector2d corner[] = {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}};
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Vector2d &start = corner[k], &end = corner[(k + 1) % 4];
    borders.push_back({static_cast<std::uint32_t>(curves.size()), start, end, 1, 0});
    curves.push_back(lineThrough(start, end));
  }
  const LabelLoops loops = labelLoops(borders, {0, 1, 0}, 1, curves);
  EXPECT_EQ(loops.outer.elements.size(), 4U);
  EXPECT_TRUE(loops.holes.empty());
}

} // namespace

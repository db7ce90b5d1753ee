// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/arrangement/label_loops.h"
#include "sedr_segmentation/src/arrangement/plan_cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

namespace {

using pcl::sedr::CellBorder;
using pcl::sedr::PlanCells;
using pcl::sedr::PlanCurve;
using pcl::sedr::PlanDivider;
using pcl::sedr::PlanLoop;

double
areaOf(const PlanCells::Polygon& polygon)
{
  double area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    area += (a.x() * b.y() - a.y() * b.x()) / 2;
  }
  return area;
}

const Eigen::AlignedBox2d square(Eigen::Vector2d(0, 0), Eigen::Vector2d(10, 10));

TEST(PlanCells, ADividerEndsAtTheNextOne)
{
  const PlanCells cells(square, {{{4, 0}, {4, 10}, 0}, {{4.5, 5}, {6, 5}, 1}});
  ASSERT_EQ(cells.polygons().size(), 3U); // the left one is not parted
  double of_second = 0;
  for (const CellBorder& border : cells.borders())
    if (border.line == 1)
      of_second += border.length();
  EXPECT_NEAR(of_second, 6, 1e-9);
}

TEST(PlanCells, ADividerPartsAlsoWhatIsThinnerThanItsEnd)
{
  // Two lines 1.3 cm apart, and one across both; one that only looks in by a
  // centimetre.
  const PlanCells cells(square, {{{4, 0}, {4, 10}, 0},
                                 {{4.013, 0}, {4.013, 10}, 1},
                                 {{-1, 5}, {11, 5}, 2},
                                 {{2, 8}, {4.01, 8}, 3}});
  // Three by two, and the upper left one parted by the last line.
  EXPECT_EQ(cells.polygons().size(), 7U);
  for (const PlanCells::Polygon& polygon : cells.polygons())
    EXPECT_LT(areaOf(polygon), 31);
}

TEST(PlanCells, KeepTheAreaAndTheLengthsUnderManyDividers)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> within(0, 10);
  std::vector<PlanDivider> dividers;
  for (std::uint32_t k = 0; k < 60; ++k)
    dividers.push_back(
        {{within(random), within(random)}, {within(random), within(random)}, k});
  const PlanCells cells(square, dividers);
  double area = 0;
  double edges = 0;
  for (const PlanCells::Polygon& polygon : cells.polygons()) {
    EXPECT_GT(areaOf(polygon), 0);
    area += areaOf(polygon);
    for (std::size_t i = 0; i < polygon.size(); ++i)
      edges += (polygon[(i + 1) % polygon.size()] - polygon[i]).norm();
  }
  EXPECT_NEAR(area, 100, 1e-6);
  double borders = 0; // each is an edge of two cells; the box has but one side
  for (const CellBorder& border : cells.borders())
    borders += border.length();
  EXPECT_NEAR(2 * borders + 40, edges, 1e-3);
}

/** @brief Lines of a grid of 1 m, and labels of the cells by the place of their middle.
 */
struct LabelledGrid {
  std::vector<PlanDivider> dividers;
  std::vector<PlanCurve> curves;
  PlanCells cells;
  std::vector<int> labels;

  template <typename LabelAt>
  explicit LabelledGrid(LabelAt label_at)
      : dividers(lines())
      , curves(curvesOf(dividers))
      , cells(square, dividers)
  {
    for (const PlanCells::Polygon& polygon : cells.polygons())
      labels.push_back(label_at(
          std::accumulate(polygon.begin(), polygon.end(), Eigen::Vector2d(0, 0)) /
          static_cast<double>(polygon.size())));
  }

  PlanLoop loop(int label) const
  {
    return labelLoops(cells.borders(), labels, label, curves).outer;
  }

private:
  static std::vector<PlanDivider> lines()
  {
    std::vector<PlanDivider> all;
    for (std::uint32_t k = 1; k < 10; ++k) {
      all.push_back({{k, 0}, {k, 10}, 2 * k - 2});
      all.push_back({{0, k}, {10, k}, 2 * k - 1});
    }
    return all;
  }

  static std::vector<PlanCurve> curvesOf(const std::vector<PlanDivider>& dividers)
  {
    std::vector<PlanCurve> curves;
    for (const PlanDivider& divider : dividers)
      curves.push_back(pcl::sedr::lineThrough(divider.start, divider.end));
    return curves;
  }
};

TEST(LabelLoops, RoomsThatTouchAtACornerAreSimple)
{
  const LabelledGrid grid([](const Eigen::Vector2d& p) {
    if (p.x() < 1 || p.y() < 1 || p.x() > 9 || p.y() > 9)
      return 0;
    return (p.x() < 5) == (p.y() < 5) ? 1 : 2;
  });
  for (const int label : {1, 2}) {
    const PlanLoop loop = grid.loop(label);
    EXPECT_EQ(loop.elements.size(), 4U) << label;
    EXPECT_NEAR(loop.area(), 16, 1e-9) << label;
  }
}

TEST(LabelLoops, TheOuterBorderGoesAroundACourtyard)
{
  const LabelledGrid grid([](const Eigen::Vector2d& p) {
    const bool is_court = p.x() > 3 && p.y() > 3 && p.x() < 5 && p.y() < 5;
    return p.x() > 1 && p.y() > 1 && p.x() < 8 && p.y() < 8 && !is_court ? 1 : 0;
  });
  const PlanLoop loop = grid.loop(1);
  EXPECT_EQ(loop.elements.size(), 4U);
  EXPECT_NEAR(loop.area(), 49, 1e-9);
}

} // namespace

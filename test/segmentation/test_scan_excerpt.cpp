// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/scan_excerpt.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace {

using pcl::sedr::addToExcerpt;
using pcl::sedr::PointView;
using pcl::sedr::ScanSample;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/** @brief Points (k, 0, 0), every 1000th not finite; `last` has the largest float, with
 * which sums overflow. */
std::vector<Eigen::Vector3f>
countedPoints(std::size_t n, std::size_t last)
{
  std::vector<Eigen::Vector3f> points;
  for (std::size_t k = 0; k < n; ++k)
    points.emplace_back(static_cast<float>(k), k % 1000 == 0 ? nan : 0.f, 0);
  points[last].setConstant(std::numeric_limits<float>::max());
  return points;
}

PointView
part(const std::vector<Eigen::Vector3f>& points, std::size_t begin, std::size_t end)
{
  return {points[begin].data(), sizeof points[0], end - begin};
}

TEST(Excerpt, HasEveryKthPointWhateverThePiecesAndThreads)
{
  // Pieces of several blocks of the threads, and some of less than a step.
  const std::vector<Eigen::Vector3f> points = countedPoints(300000, 299999);
  const std::vector<std::size_t> cuts{0, 3, 200001, 200002, 300000};
  for (const std::size_t step : {std::size_t{1}, std::size_t{7}})
    for (const unsigned threads : {1u, 4u}) {
      std::vector<Eigen::Vector3f> excerpt;
      ScanSample sample(points.size());
      for (std::size_t c = 0; c + 1 < cuts.size(); ++c)
        addToExcerpt(part(points, cuts[c], cuts[c + 1]), cuts[c], step, threads, sample,
                     excerpt);
      EXPECT_EQ(sample.finite(), 299700u);
      ASSERT_EQ(excerpt.size(), (points.size() - 1) / step + 1);
      for (std::size_t k = 0; k < excerpt.size(); ++k) {
        ASSERT_EQ(excerpt[k].x(), points[k * step].x()) << "step " << step;
        ASSERT_EQ(std::isnan(excerpt[k].y()), std::isnan(points[k * step].y()));
      }
    }
}

TEST(ScanSample, CountsThePointsThatAreFinite)
{
  std::vector<Eigen::Vector3f> points = countedPoints(70000, 1);
  ScanSample sample(points.size());
  sample.add(part(points, 0, points.size()), 2);
  EXPECT_EQ(sample.finite(), 69930u);
  points[69999].z() = -std::numeric_limits<float>::infinity();
  ScanSample again(points.size());
  again.add(part(points, 0, points.size()), 2);
  EXPECT_EQ(again.finite(), 69929u);
}

} // namespace

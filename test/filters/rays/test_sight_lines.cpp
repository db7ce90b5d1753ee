// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/rays/sight_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using pcl::sedr::Levelling;
using pcl::sedr::SightLine;
using pcl::sedr::SightLines;

/** Rays from some places to points all around. */
std::vector<SightLine>
randomLines(std::size_t n)
{
  std::mt19937 random(5);
  std::normal_distribution<float> normal;
  std::uniform_real_distribution<float> range(0.3F, 8);
  const std::vector<Vector3f> places{{0, 0, 0}, {2, 1, 0.5F}, {-3, 4, 1}};
  std::vector<SightLine> lines;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector3f from = places[i % places.size()];
    const Vector3f way(normal(random), normal(random), normal(random));
    lines.push_back({from, from + range(random) * way.normalized()});
  }
  return lines;
}

/** Returns whether a ray goes through, ray by ray. */
bool
pierced(const std::vector<SightLine>& lines,
        const Vector3d& place,
        const Vector3d& normal,
        double radius)
{
  return std::any_of(lines.begin(), lines.end(), [&](const SightLine& line) {
    const Vector3d from = line.from.cast<double>();
    const Vector3d to = line.to.cast<double>();
    const double start = (from - place).dot(normal);
    const double end = (to - place).dot(normal);
    if (std::abs(start) <= 0.15 || std::abs(end) <= 0.15 || start * end > 0)
      return false;
    const double share = start / (start - end);
    return (from + share * (to - from) - place).norm() <= radius;
  });
}

TEST(SightLines, PierceAsRayByRayInEveryDirection)
{
  const std::vector<SightLine> lines = randomLines(30000);
  const SightLines sight(lines);
  EXPECT_EQ(sight.size(), lines.size());
  std::mt19937 random(6);
  std::normal_distribution<double> normal;
  int through = 0;
  for (int i = 0; i < 300; ++i) {
    Vector3d place(3 * normal(random), 3 * normal(random), 2 * normal(random));
    if (i % 10 == 0)
      place.head<2>() = Eigen::Vector2d(0.01 * normal(random), 0); // above a place
    const Vector3d across =
        Vector3d(normal(random), normal(random), normal(random)).normalized();
    const bool expected = pierced(lines, place, across, 0.05);
    EXPECT_EQ(sight.across(place, across, 0.05).through > 0, expected)
        << place.transpose();
    through += expected ? 1 : 0;
  }
  EXPECT_GT(through, 30);
  EXPECT_LT(through, 270);
}

TEST(SightLines, WithoutRaysAndOfNaNTellNothing)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const SightLines sight({{{0, 0, nan}, {1, 1, 1}}, {{1, 1, 1}, {1, 1, 1}}});
  EXPECT_EQ(sight.size(), 0u);
  EXPECT_EQ(sight.across({1, 1, 1}, Vector3d::UnitX(), 1).through, 0u);
}

} // namespace

// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/shapes/shape_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace {

using namespace pcl::sedr;

/** Points of a height field over 4 m x 3 m; a tenth of them are strays below it. */
std::vector<Eigen::Vector3d>
pointsOf(const std::function<double(double, double)>& height, double noise)
{
  std::mt19937 random(3);
  std::normal_distribution<double> off(0, noise);
  std::vector<Eigen::Vector3d> points;
  int k = 0;
  for (double y = 0; y < 3; y += 0.1)
    for (double x = 0; x < 4; x += 0.1)
      points.emplace_back(x, y, height(x, y) + off(random) - (++k % 10 == 0 ? 0.3 : 0));
  return points;
}

PlanSlab
fitOf(ShapeKind kind, const std::vector<Eigen::Vector3d>& points)
{
  PlanSlab slab = startShape(kind, points, {});
  for (const double deviation : {0.1, 0.03, 0.01})
    refineShape(kind, points, deviation, slab);
  return slab;
}

TEST(ShapeFit, ACylinderIsFoundInAnyDirection)
{
  for (const double degrees : {0.0, 25.0, 90.0, 140.0}) {
    const double a = degrees * M_PI / 180;
    const auto points = pointsOf(
        [&](double x, double y) {
          const double v = -std::sin(a) * (x - 2) + std::cos(a) * (y - 1.4);
          return 1 + std::sqrt(9 - v * v);
        },
        0.005);
    const PlanSlab slab = fitOf(ShapeKind::Cylinder, points);
    ASSERT_TRUE(slab.curve);
    EXPECT_NEAR(slab.curve->across, 3, 0.03) << degrees;
    EXPECT_NEAR(
        std::abs(slab.curve->axis.dot(Eigen::Vector2d(std::cos(a), std::sin(a)))), 1,
        1e-4);
  }
}

TEST(ShapeFit, AnEllipsoidIsFound)
{
  const auto flat = [](double x, double y) {
    return 2 + std::sqrt(1 - std::pow((x - 2) / 3, 2) - std::pow((y - 1.5) / 2.2, 2));
  };
  const PlanSlab oval = fitOf(ShapeKind::Ellipsoid, pointsOf(flat, 0.003));
  ASSERT_TRUE(oval.curve);
  for (const Eigen::Vector2d& p : {Eigen::Vector2d(0.3, 0.4), {2, 1.5}, {3.5, 2}})
    EXPECT_NEAR(oval.heightAt(p), flat(p.x(), p.y()), 0.004);
}

TEST(ShapeFit, WhatSagsIsNoVault)
{
  const auto points = pointsOf(
      [](double x, double) { return 5 - std::sqrt(9 - (x - 2) * (x - 2)); }, 0.002);
  EXPECT_FALSE(startShape(ShapeKind::Cylinder, points, {}).curve);
  EXPECT_FALSE(startShape(ShapeKind::Sphere, points, {}).curve);
  const PlanSlab start = startShape(ShapeKind::Sphere, points, {});
  PlanSlab slab = start;
  refineShape(ShapeKind::Sphere, points, 0.01, slab);
  refineShape(ShapeKind::Plane, {}, 0.01, slab);
  EXPECT_EQ(slab.plane, start.plane);
}

} // namespace

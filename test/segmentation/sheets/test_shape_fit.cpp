// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/shapes/shape_distance.h"
#include "sedr_segmentation/src/shapes/shape_fit.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <vector>

namespace {

using namespace pcl::sedr;

constexpr ShapeKind all_kinds[] = {ShapeKind::Level,
                                   ShapeKind::Plane,
                                   ShapeKind::Cylinder,
                                   ShapeKind::Sphere,
                                   ShapeKind::EllipticCylinder,
                                   ShapeKind::Ellipsoid};

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

PlanSlab
slabOf(ShapeKind kind)
{
  if (kind == ShapeKind::Level)
    return planeThrough({1, 2, 3}, {0, 0});
  PlanSlab slab = planeThrough({1, 2, 3}, {0.3, -0.2});
  if (kind == ShapeKind::Plane)
    return slab;
  SlabCurve curve;
  curve.kind = kind == ShapeKind::Sphere || kind == ShapeKind::Ellipsoid
                   ? CurveKind::Ellipsoid
                   : CurveKind::Cylinder;
  const bool is_round = kind == ShapeKind::Cylinder || kind == ShapeKind::Sphere;
  curve.setDirection(0.4);
  curve.centre = {1.9, 1.4};
  curve.base = -0.3;
  curve.up = 2.5;
  curve.across = is_round ? 2.5 : 3.5;
  curve.along = is_round ? 2.5 : 4.5;
  slab.curve = std::make_shared<const SlabCurve>(curve);
  return slab;
}

TEST(ShapeFit, DistancesOfManyPointsAreThoseOfEach)
{
  const auto points = pointsOf([](double x, double y) { return x + y / 3; }, 0.1);
  for (const ShapeKind kind : all_kinds) {
    const PlanSlab slab = slabOf(kind);
    std::size_t k = 0;
    for (const PointRow& row : rowsOf(points)) {
      ShapeValues distance;
      ShapeValues by_shape;
      distancesOf(slab, row, distance);
      ShapeDistance(kind, slab, {1, 1, 1}).of(row, by_shape);
      for (Eigen::Index i = 0; i < row.size(); ++i, ++k) {
        EXPECT_NEAR(distance[i], distanceOf(slab, points[k]), 1e-12);
        EXPECT_NEAR(by_shape[i], distance[i], 1e-12);
      }
    }
    EXPECT_EQ(k, points.size());
  }
}

/** The slab with one of its numbers changed: its height, if it is level; of a plane its
 * slopes and its height at `about`; of a cylinder its direction, how far its axis is to
 * the left of `about`, its crown and its inverse radii; of others place, crown,
 * direction and inverse radii. */
PlanSlab
changed(ShapeKind kind, const Eigen::Vector3d& about, int number, double step)
{
  PlanSlab slab = slabOf(kind);
  if (kind == ShapeKind::Level)
    return planeThrough({0, 0, slab.heightAt({0, 0}) + step}, {0, 0});
  if (kind == ShapeKind::Plane) {
    const Eigen::Vector4d& p = slab.plane;
    Eigen::Vector2d slope = -p.head<2>() / p[2];
    double height = slab.heightAt(about.head<2>());
    (number < 2 ? slope[number] : height) += step;
    return planeThrough({about.x(), about.y(), height}, slope);
  }
  SlabCurve c = *slab.curve;
  const bool is_cylinder = c.kind == CurveKind::Cylinder;
  const Eigen::Vector2d left(-c.axis.y(), c.axis.x());
  const Eigen::Vector2d off = c.centre - about.head<2>();
  std::vector<std::function<void()>> change;
  const auto shorten = [&](std::vector<double*> radii) {
    change.emplace_back([step, &c, radii] {
      const double crown = c.base + c.up;
      for (double* radius : radii)
        *radius = 1 / (1 / *radius + step);
      c.base = crown - c.up;
    });
  };
  const auto turn = [&] { c.setDirection(c.direction() + step); };
  if (is_cylinder) {
    change.emplace_back([&] {
      turn();
      c.centre =
          about.head<2>() + off.dot(left) * Eigen::Vector2d(-c.axis.y(), c.axis.x());
    });
    change.emplace_back([&] { c.centre += step * left; });
  }
  else {
    change.emplace_back([&] { c.centre.x() += step; });
    change.emplace_back([&] { c.centre.y() += step; });
  }
  change.emplace_back([&] { c.base += step; });
  if (kind == ShapeKind::Cylinder)
    shorten({&c.across, &c.up});
  else if (kind == ShapeKind::Sphere)
    shorten({&c.along, &c.across, &c.up});
  else {
    if (!is_cylinder) {
      change.emplace_back(turn);
      shorten({&c.along});
    }
    shorten({&c.across});
    shorten({&c.up});
  }
  EXPECT_EQ(change.size(), static_cast<std::size_t>(parametersOf(kind)));
  change[static_cast<std::size_t>(number)]();
  slab.curve = std::make_shared<const SlabCurve>(c);
  return slab;
}

/** A fit is as good as the derivatives of distances are right. */
TEST(ShapeFit, DistancesGrowWithTheNumbersOfAShape)
{
  const auto points = pointsOf([](double x, double y) { return 1.5 + x * y / 9; }, 0.1);
  const PointRow row = rowsOf(points).front();
  const Eigen::Vector3d about(1.2, 0.9, 1);
  constexpr double step = 1e-5;
  for (const ShapeKind kind : all_kinds) {
    ShapeValues here;
    std::array<ShapeValues, 7> growth;
    ShapeDistance(kind, slabOf(kind), about).of(row, here, growth);
    for (int k = 0; k < parametersOf(kind); ++k) {
      ShapeValues less;
      ShapeValues more;
      ShapeDistance(kind, changed(kind, about, k, -step), about).of(row, less);
      ShapeDistance(kind, changed(kind, about, k, step), about).of(row, more);
      EXPECT_LT(((more - less) / (2 * step) - growth[static_cast<std::size_t>(k)])
                    .abs()
                    .maxCoeff(),
                1e-6)
          << "number " << k << " of kind " << static_cast<int>(kind);
    }
  }
}

TEST(ShapeFit, APlaneIsFoundAmongStrays)
{
  const auto points =
      pointsOf([](double x, double y) { return 2 + 0.5 * x - 0.2 * y; }, 0.005);
  const PlanSlab slab = fitOf(ShapeKind::Plane, points);
  EXPECT_NEAR(slab.heightAt({2, 1}), 2.8, 0.001);
  EXPECT_NEAR(-slab.plane[0] / slab.plane[2], 0.5, 0.001);
}

TEST(ShapeFit, ALevelPlaneStaysLevelBelowAHigherEdge)
{
  const auto points =
      pointsOf([](double x, double) { return x < 3.6 ? 2.5 : 2.6; }, 0.005);
  const PlanSlab slab = fitOf(ShapeKind::Level, points);
  EXPECT_NEAR(slab.heightAt({0, 0}), 2.5, 0.001);
  EXPECT_TRUE(slab.plane.head<2>().isZero(0));
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

TEST(ShapeFit, ASphereAndAnEllipsoidAreFound)
{
  const auto sphere = pointsOf(
      [](double x, double y) {
        return 0.5 + std::sqrt(16 - std::pow(x - 2, 2) - std::pow(y - 1.5, 2));
      },
      0.005);
  const PlanSlab cap = fitOf(ShapeKind::Sphere, sphere);
  ASSERT_TRUE(cap.curve);
  EXPECT_NEAR(cap.curve->up, 4, 0.04);
  EXPECT_TRUE(cap.curve->isSphere());
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
  PlanSlab slab = startShape(ShapeKind::Sphere, points, {});
  EXPECT_FALSE(std::isfinite(refineShape(ShapeKind::Sphere, points, 0.01, slab)));
  EXPECT_FALSE(std::isfinite(refineShape(ShapeKind::Plane, {}, 0.01, slab)));
}

} // namespace

// SPDX-License-Identifier: BSD-3-Clause
#include "border_part.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr {

namespace {

Eigen::Vector2d
gradientOf(const PlanSlab& slab, const Eigen::Vector2d& p)
{
  if (slab.curve)
    return slab.curve->gradientAt(p);
  return -slab.plane.head<2>() / slab.plane[2];
}

/** @brief How far a place is from where two facets are closest to each other, square to
 * the axis of that which is a vault, and the way to there, backwards; endless where
 * neither is. */
std::pair<double, Eigen::Vector2d>
besideTouch(const PlanSlab& one, const PlanSlab& other, const Eigen::Vector2d& p)
{
  constexpr double step = 1e-3;     // metres
  constexpr double min_bend = 1e-3; // a metre
  const auto isVault = [](const PlanSlab& slab) {
    return slab.curve && slab.curve->kind == CurveKind::Cylinder;
  };
  const double endless = std::numeric_limits<double>::infinity();
  if (!isVault(one) && !isVault(other))
    return {endless, Eigen::Vector2d::UnitX()};
  const Eigen::Vector2d& axis = (isVault(one) ? one : other).curve->axis;
  const Eigen::Vector2d across(-axis.y(), axis.x());
  const auto slopeAt = [&](double off) {
    const Eigen::Vector2d q = p + off * across;
    return across.dot(gradientOf(one, q) - gradientOf(other, q));
  };
  const double bend = (slopeAt(step) - slopeAt(-step)) / (2 * step);
  return {std::abs(bend) > min_bend ? slopeAt(0) / bend : endless, across};
}

} // namespace

std::pair<double, Eigen::Vector2d>
BorderPart::sideOf(const Eigen::Vector2d& p) const
{
  if (!meets())
    return {normal.dot(p - through), normal};
  if (touches)
    return besideTouch(*one, *other, p);
  const Eigen::Vector2d slope = gradientOf(*one, p) - gradientOf(*other, p);
  const double size = std::max(slope.norm(), 1e-6);
  return {(one->heightAt(p) - other->heightAt(p)) / size, slope / size};
}

std::optional<Eigen::Vector2d>
BorderPart::project(const Eigen::Vector2d& from, double farthest) const
{
  constexpr int max_steps = 12;
  constexpr double exact = 1e-6;
  constexpr double closest = 0.01; // metres between facets that touch
  const auto isApart = [&](const Eigen::Vector2d& place) {
    return touches &&
           !(std::abs(one->heightAt(place) - other->heightAt(place)) < closest);
  };
  Eigen::Vector2d p = from;
  for (int step = 0; step < max_steps; ++step) {
    const auto [off, way] = sideOf(p);
    if (std::abs(off) < exact)
      return isApart(p) ? std::nullopt : std::optional<Eigen::Vector2d>(p);
    if (!(std::abs(off) < 2 * farthest))
      return std::nullopt;
    p -= off * way;
    if ((p - from).norm() > farthest)
      return std::nullopt;
  }
  return std::abs(sideOf(p).first) < border_tolerance && !isApart(p)
             ? std::optional<Eigen::Vector2d>(p)
             : std::nullopt;
}

std::optional<Eigen::Vector2d>
crossing(const BorderPart& a,
         const BorderPart& b,
         const Eigen::Vector2d& near,
         double farthest)
{
  constexpr int max_steps = 15;
  constexpr double min_angle = 0.15; // sine
  Eigen::Vector2d p = near;
  for (int step = 0; step < max_steps; ++step) {
    const auto [off_a, way_a] = a.sideOf(p);
    const auto [off_b, way_b] = b.sideOf(p);
    Eigen::Matrix2d rows;
    rows << way_a.transpose(), way_b.transpose();
    if (std::abs(rows.determinant()) < min_angle)
      return std::nullopt;
    const Eigen::Vector2d move = rows.inverse() * Eigen::Vector2d(off_a, off_b);
    p -= move;
    if (!p.allFinite() || (p - near).norm() > farthest)
      return std::nullopt;
    if (move.norm() < 1e-7)
      return p;
  }
  return std::nullopt;
}

} // namespace pcl::sedr

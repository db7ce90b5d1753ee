// SPDX-License-Identifier: BSD-3-Clause
#include "border_part.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

constexpr int max_steps = 15;

Eigen::Vector2d
gradientOf(const PlanSlab& slab, const Eigen::Vector2d& p)
{
  if (slab.curve)
    return slab.curve->gradientAt(p);
  return -slab.plane.head<2>() / slab.plane[2];
}

} // namespace

std::pair<double, Eigen::Vector2d>
BorderPart::sideOf(const Eigen::Vector2d& p) const
{
  if (!meets())
    return {normal.dot(p - through), normal};
  const Eigen::Vector2d slope = gradientOf(*one, p) - gradientOf(*other, p);
  const double size = std::max(slope.norm(), 1e-6);
  return {(one->heightAt(p) - other->heightAt(p)) / size, slope / size};
}

std::optional<Eigen::Vector2d>
BorderPart::project(const Eigen::Vector2d& from, double farthest) const
{
  constexpr double exact = 1e-6;
  Eigen::Vector2d p = from;
  for (int step = 0; step < max_steps; ++step) {
    const auto [off, way] = sideOf(p);
    if (std::abs(off) < exact)
      return p;
    if (!(std::abs(off) < 2 * farthest))
      return std::nullopt;
    p -= off * way;
    if ((p - from).norm() > farthest)
      return std::nullopt;
  }
  return std::abs(sideOf(p).first) < border_tolerance
             ? std::optional<Eigen::Vector2d>(p)
             : std::nullopt;
}

std::optional<Eigen::Vector2d>
crossing(const BorderPart& a,
         const BorderPart& b,
         const Eigen::Vector2d& near,
         double farthest)
{
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

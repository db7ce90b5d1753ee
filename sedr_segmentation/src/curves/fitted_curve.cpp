// SPDX-License-Identifier: BSD-3-Clause
#include "fitted_curve.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr {

namespace {

PlanCurve
weightedLine(const std::vector<Eigen::Vector2d>& places, const std::vector<double>& w)
{
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  double sum = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    mean += w[i] * places[i];
    sum += w[i];
  }
  mean /= sum;
  Eigen::Matrix2d c = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < places.size(); ++i)
    c += w[i] * (places[i] - mean) * (places[i] - mean).transpose();
  const double turn = 0.5 * std::atan2(2 * c(0, 1), c(0, 0) - c(1, 1));
  PlanCurve line;
  line.point = mean;
  line.direction = {std::cos(turn), std::sin(turn)};
  return line;
}

/** @brief Fits a circle: algebraic, then four steps of Gauss-Newton. */
PlanCurve
weightedCircle(const std::vector<Eigen::Vector2d>& places, const std::vector<double>& w)
{
  const Eigen::Vector2d origin = places.front();
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Eigen::Vector2d q = places[i] - origin;
    const Eigen::Vector3d row(2 * q.x(), 2 * q.y(), 1);
    a += w[i] * row * row.transpose();
    b += w[i] * q.squaredNorm() * row;
  }
  const Eigen::Vector3d s = a.ldlt().solve(b);
  PlanCurve circle;
  circle.point = s.head<2>() + origin;
  circle.radius = std::sqrt(std::max(s.z() + s.head<2>().squaredNorm(), 1e-12));
  for (int step = 0; step < 4; ++step) {
    a.setZero();
    b.setZero();
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Eigen::Vector2d d = places[i] - circle.point;
      const double r = std::max(d.norm(), 1e-9);
      const Eigen::Vector3d row(-d.x() / r, -d.y() / r, -1);
      a += w[i] * row * row.transpose();
      b -= w[i] * (r - circle.radius) * row;
    }
    const Eigen::Vector3d change = a.ldlt().solve(b);
    if (!change.allFinite())
      break;
    circle.point += change.head<2>();
    circle.radius += change.z();
  }
  if (!circle.point.allFinite() || !(circle.radius > 0))
    circle.radius = 1e12; // no circle
  return circle;
}

} // namespace

PlanCurve
fitCurve(bool is_circle, const std::vector<Eigen::Vector2d>& places, double sigma)
{
  std::vector<double> w(places.size(), 1);
  std::vector<double> d(places.size());
  PlanCurve curve;
  for (int round = 0; round < 4; ++round) {
    curve = is_circle ? weightedCircle(places, w) : weightedLine(places, w);
    for (std::size_t i = 0; i < places.size(); ++i)
      d[i] = curve.distance(places[i]);
    std::vector<double> sorted = d;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(d.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const double scale = 4 * std::max(sigma, 1.4826 * *middle);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double u = std::max(0.0, 1 - (d[i] / scale) * (d[i] / scale));
      w[i] = u * u + 1e-9;
    }
  }
  return curve;
}

bool
meet(const PlanCurve& a,
     const PlanCurve& b,
     const Eigen::Vector2d& near,
     Eigen::Vector2d& place)
{
  if (!a.isCircle() && !b.isCircle()) {
    constexpr double parallel = 0.02; // radians
    const double turn =
        a.direction.x() * b.direction.y() - a.direction.y() * b.direction.x();
    if (std::abs(turn) < parallel)
      return false;
    place = a.point + b.signedDistance(a.point) / turn * a.direction;
    return true;
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& p : intersections(a, b))
    if ((p - near).norm() < nearest) {
      nearest = (p - near).norm();
      place = p;
    }
  return std::isfinite(nearest);
}

} // namespace pcl::sedr

// SPDX-License-Identifier: BSD-3-Clause
#include "column_rectangle.h"

#include "rectangle_sides.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace pcl::sedr {

namespace {

std::vector<Eigen::Vector2d>
framed(const std::vector<Eigen::Vector2d>& points, const Rectangle& r)
{
  std::vector<Eigen::Vector2d> in_frame;
  in_frame.reserve(points.size());
  for (const auto& p : points)
    in_frame.push_back(r.inFrame(p));
  return in_frame;
}

/** @brief Sorts lines by the number of points within `band`, with nearer points
 * weighted more. */
std::vector<PlanCurve>
bestFirst(const std::vector<PlanCurve>& lines,
          const std::vector<Eigen::Vector2d>& points,
          double band)
{
  const auto n = static_cast<Eigen::Index>(lines.size());
  // All lines at once, so the sums are independent of each other.
  Eigen::ArrayXd x(n), y(n), left_x(n), left_y(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const PlanCurve& line = lines[static_cast<std::size_t>(k)];
    x[k] = line.point.x();
    y[k] = line.point.y();
    left_x[k] = leftOf(line.direction).x();
    left_y[k] = leftOf(line.direction).y();
  }
  Eigen::ArrayXd score = Eigen::ArrayXd::Zero(n);
  for (const auto& p : points)
    score += (1 - (((p.x() - x) * left_x + (p.y() - y) * left_y).abs() / band).square())
                 .max(0.0);
  std::vector<std::size_t> order(lines.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return score[static_cast<Eigen::Index>(a)] > score[static_cast<Eigen::Index>(b)];
  });
  std::vector<PlanCurve> ordered;
  ordered.reserve(lines.size());
  for (const std::size_t k : order)
    ordered.push_back(lines[k]);
  return ordered;
}

} // namespace

bool
Rectangle::isSound(const Priors& priors) const
{
  const auto shown = std::count_if(inliers.begin(), inliers.end(),
                                   [](std::size_t n) { return n > 0; });
  return shown >= 2 && side[1] - side[0] >= priors.min_wall &&
         side[3] - side[2] >= priors.min_wall;
}

double
Rectangle::distance(const Eigen::Vector2d& in_frame) const
{
  const double dx = std::max(side[0] - in_frame.x(), in_frame.x() - side[1]);
  const double dy = std::max(side[2] - in_frame.y(), in_frame.y() - side[3]);
  const bool is_beyond_corner = dx > 0 && dy > 0;
  return is_beyond_corner ? std::hypot(dx, dy) : std::abs(std::max(dx, dy));
}

PlanLoop
Rectangle::loop() const
{
  const auto at = [&](std::size_t x, std::size_t y) {
    return Eigen::Vector2d(side[x] * direction + side[y] * leftOf(direction));
  };
  const std::array<Eigen::Vector2d, 4> corners{at(0, 2), at(0, 3), at(1, 3), at(1, 2)};
  constexpr std::array<std::size_t, 4> side_of{0, 3, 1, 2};
  PlanLoop result;
  for (std::size_t i = 0; i < 4; ++i) {
    PlanElement e;
    e.start = corners[i];
    e.end = corners[(i + 1) % 4];
    e.inliers = inliers[side_of[i]];
    e.residual = residual[side_of[i]];
    result.elements.push_back(e);
  }
  return result;
}

std::vector<Eigen::Vector2d>
directionsOf(const std::vector<Eigen::Vector2d>& points,
             const LoopParameters& parameters)
{
  constexpr int trials = 300;
  const double band = parameters.priors.min_wall / 2;
  const double min_length = parameters.priors.evidence_cell;
  std::mt19937_64 random(parameters.seed);
  std::vector<PlanCurve> lines;
  for (int trial = 0; trial < trials; ++trial) {
    const Eigen::Vector2d& a = points[random() % points.size()];
    const Eigen::Vector2d& b = points[random() % points.size()];
    if ((b - a).norm() < min_length)
      continue;
    lines.push_back(lineThrough(a, b));
  }
  std::vector<Eigen::Vector2d> directions;
  for (const PlanCurve& line : bestFirst(lines, points, band)) {
    const bool is_new = std::none_of(
        directions.begin(), directions.end(), [&](const Eigen::Vector2d& d) {
          const double cosine = std::abs(d.dot(line.direction));
          return std::min(cosine, std::abs(leftOf(d).dot(line.direction))) < 0.17;
        });
    if (is_new)
      directions.push_back(line.direction);
    if (directions.size() == 2)
      break;
  }
  return directions;
}

Rectangle
findRectangle(const std::vector<Eigen::Vector2d>& points,
              const Eigen::Vector2d& direction,
              const LoopParameters& parameters)
{
  const double tolerance = parameters.tolerance;
  const double min_side = parameters.priors.min_wall;
  const double width = tolerance / 2;
  Rectangle best;
  best.direction = direction;
  const std::vector<Eigen::Vector2d> in_frame = framed(points, best);
  std::array<std::vector<double>, 2> places;
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    std::vector<double> values;
    for (const auto& p : in_frame)
      values.push_back(p[axis]);
    std::sort(values.begin(), values.end());
    auto& own = places[static_cast<std::size_t>(axis)];
    own = peaksOf(values, width);
    own.push_back(endOf(values, false, tolerance));
    own.push_back(endOf(values, true, tolerance));
    std::sort(own.begin(), own.end());
  }
  double least = static_cast<double>(points.size());
  const auto tryOne = [&](double x0, double x1, double y0, double y1) {
    Rectangle trial;
    trial.direction = direction;
    trial.side = {x0, x1, y0, y1};
    double missed = 0;
    for (auto p = in_frame.begin(); p != in_frame.end() && missed < least; ++p)
      missed += std::min(1.0, std::pow(trial.distance(*p) / tolerance, 2));
    if (missed >= least)
      return;
    least = missed;
    best = trial;
  };
  for (const double x0 : places[0])
    for (const double x1 : places[0])
      for (const double y0 : places[1])
        for (const double y1 : places[1])
          if (x1 - x0 >= min_side && y1 - y0 >= min_side)
            tryOne(x0, x1, y0, y1);
  // Fits the sides with points, then places the others.
  for (int round = 0; round < 3; ++round) {
    const auto sides = pointsOfSides(in_frame, best, tolerance);
    for (std::size_t k = 0; k < 4; ++k) {
      std::vector<double> own;
      for (const auto& p : sides[k])
        own.push_back(p[static_cast<Eigen::Index>(k / 2)]);
      if (own.size() < 5)
        continue;
      std::sort(own.begin(), own.end());
      const double middle = quantile(own, 0.5);
      double sum = 0;
      double count = 0;
      for (const double v : own)
        if (std::abs(v - middle) <= tolerance) {
          sum += v;
          count += 1;
        }
      best.side[k] = sum / count;
    }
    judgeSides(in_frame, tolerance, best);
  }
  return best;
}

Rectangle
fitTurnedRectangle(const std::vector<Eigen::Vector2d>& points,
                   const Rectangle& start,
                   const LoopParameters& parameters)
{
  const double tolerance = parameters.tolerance;
  Rectangle r = start;
  for (int round = 0; round < 8 && r.isSound(parameters.priors); ++round) {
    const auto sides = pointsOfSides(framed(points, r), r, tolerance);
    // Unknowns: a rotation about the centre, and a shift of each side.
    Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Identity() * 1e-9;
    Eigen::Matrix<double, 5, 1> right = Eigen::Matrix<double, 5, 1>::Zero();
    const Eigen::Vector2d middle((r.side[0] + r.side[1]) / 2,
                                 (r.side[2] + r.side[3]) / 2);
    for (std::size_t k = 0; k < 4; ++k) {
      if (r.inliers[k] == 0)
        continue;
      for (const auto& p : sides[k]) {
        Eigen::Matrix<double, 5, 1> row = Eigen::Matrix<double, 5, 1>::Zero();
        row[static_cast<Eigen::Index>(k)] = 1;
        row[4] = k < 2 ? -(p.y() - middle.y()) : p.x() - middle.x();
        normal.noalias() += row * row.transpose();
        right += row * r.fromSide(p, k);
      }
    }
    const Eigen::Matrix<double, 5, 1> step = normal.ldlt().solve(right);
    const double turn = step[4];
    if (!step.allFinite() || std::abs(turn) > 0.3)
      return start;
    // The rectangle rotates about its centre, which stays in place.
    const Eigen::Vector2d centre =
        middle.x() * r.direction + middle.y() * leftOf(r.direction);
    r.direction = (r.direction + turn * leftOf(r.direction)).normalized();
    const Eigen::Vector2d moved = r.inFrame(centre);
    for (std::size_t k = 0; k < 4; ++k)
      r.side[k] += step[static_cast<Eigen::Index>(k)] +
                   moved[static_cast<Eigen::Index>(k / 2)] -
                   middle[static_cast<Eigen::Index>(k / 2)];
    judgeSides(framed(points, r), tolerance, r);
    if (step.norm() < 1e-7)
      break;
  }
  return r;
}

} // namespace pcl::sedr

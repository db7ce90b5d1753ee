// SPDX-License-Identifier: BSD-3-Clause
#include "energy_fit.h"

#include "../curves/fitted_curve.h"
#include "../curves/plan_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Returns the deviations of places from the straight stretches on which they
 * lie, stretch by stretch; stretches that are not straight are left out. */
std::vector<std::vector<double>>
stretchDeviations(const std::vector<FittedBoundary>& boundaries)
{
  constexpr double straight = 0.05; // metres: what is farther off is no noise
  constexpr double along = 0.99;    // cosine
  constexpr std::size_t length = 24;
  std::vector<std::vector<double>> all;
  for (const FittedBoundary& boundary : boundaries)
    for (std::size_t s = 0; s + length <= boundary.samples.size(); s += length / 2) {
      std::vector<Eigen::Vector2d> seen; // not around a corner
      for (std::size_t k = s; k < s + length; ++k) {
        const ContourSample& sample = boundary.samples[k];
        if (sample.isSupported() &&
            std::abs(sample.tangent.dot(boundary.samples[s].tangent)) > along)
          seen.push_back(sample.position);
      }
      if (seen.size() < length)
        continue;
      const PlanCurve line = fitCurve(false, seen, straight / 4);
      std::vector<double> off;
      for (const Eigen::Vector2d& p : seen)
        off.push_back(line.signedDistance(p));
      const auto isFar = [&](double d) { return std::abs(d) > straight; };
      if (std::none_of(off.begin(), off.end(), isFar))
        all.push_back(std::move(off));
    }
  return all;
}

/** @brief Returns the variance of deviations, and that over their correlation: the sum
 * of the autocovariance up to its first zero. */
std::pair<double, double>
variances(const std::vector<double>& off)
{
  const auto covariance = [&](std::size_t lag) {
    double sum = 0;
    for (std::size_t k = 0; k + lag < off.size(); ++k)
      sum += off[k] * off[k + lag];
    return sum / static_cast<double>(off.size() - lag);
  };
  const double variance = covariance(0);
  double sum = variance;
  for (std::size_t lag = 1; lag < off.size() / 2; ++lag) {
    const double c = covariance(lag);
    if (!(c > 0))
      break;
    sum += 2 * c;
  }
  return {variance, sum};
}

} // namespace

std::vector<FittedBoundary>
outlineSamples(const PlanRoom& room,
               const RoomCells& cells,
               double spacing,
               double near)
{
  const PlanPoints points(cells.wall_points, 0.2);
  std::vector<FittedBoundary> boundaries;
  const auto add = [&](const PlanLoop& loop, StructureLabel label) {
    FittedBoundary& boundary = boundaries.emplace_back();
    boundary.room = room.id;
    boundary.label = label;
    for (const PlanElement& element : loop.elements) {
      const PlanCurve curve = carrierOf(element);
      const double length = element.length();
      const auto count = static_cast<std::size_t>(std::ceil(length / spacing));
      for (std::size_t k = 0; k < count; ++k) {
        ContourSample sample;
        sample.place = element.pointAt((static_cast<double>(k) + 0.5) /
                                       static_cast<double>(count) * length);
        sample.tangent = curve.tangentAt(sample.place);
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        points.forEachWithin(
            sample.place, std::hypot(near, spacing / 2), [&](const Eigen::Vector2d& p) {
              if (std::abs(sample.tangent.dot(p - sample.place)) > spacing / 2 ||
                  curve.distance(p) > near)
                return;
              ++sample.points;
              sum += p;
            });
        constexpr double enough = 3; // points, for a clear wall
        sample.support = std::min(1.0, static_cast<double>(sample.points) / enough);
        sample.position = sample.points > 0
                              ? (sum / static_cast<double>(sample.points)).eval()
                              : sample.place;
        boundary.samples.push_back(sample);
      }
    }
  };
  add(room.boundary, StructureLabel::Wall);
  for (const PlanLoop& column : room.columns)
    add(column, StructureLabel::Column);
  return boundaries;
}

WallNoise
wallNoise(const std::vector<FittedBoundary>& boundaries, double spacing)
{
  constexpr std::size_t enough = 4; // stretches
  WallNoise noise;
  const auto stretches = stretchDeviations(boundaries);
  if (stretches.size() < enough)
    return noise;
  std::vector<double> off;
  double variance = 0;
  double sum = 0;
  for (const auto& stretch : stretches) {
    for (const double d : stretch)
      off.push_back(std::abs(d));
    const auto [of_place, of_wave] = variances(stretch);
    variance += of_place;
    sum += of_wave;
  }
  // The quartile of a normal distribution is 1.15 sigma.
  const auto rank = off.begin() + static_cast<std::ptrdiff_t>(off.size() * 3 / 4);
  std::nth_element(off.begin(), rank, off.end());
  noise.measured = *rank / 1.15;
  noise.correlation = variance > 0 ? spacing * sum / variance : spacing;
  noise.stretches = stretches.size();
  return noise;
}

OutlineCover
coverOf(const PlanRoom& room,
        const std::vector<const PlanRoom*>& others,
        const RoomCells& cells,
        const CellGrid& grid,
        double max_wall)
{
  const CellMask near = dilated(cells.seen, 1);
  double inside = 0;
  double outside = 0;
  for (std::size_t i = 0; i < near.values().size(); ++i) {
    if (!near.values()[i])
      continue;
    const Cell cell = near.cellAt(i);
    const Eigen::Vector2d p = grid.centre(cell);
    const auto isIn = [&](const PlanRoom* other) { return other->contains(p); };
    if (room.contains(p))
      ++inside;
    else if (cells.seen.at(cell) && room.boundary.distance(p) > max_wall &&
             std::none_of(others.begin(), others.end(), isIn))
      ++outside;
  }
  const double area = grid.size() * grid.size();
  return {area * outside, std::max(0.0, room.area() - area * inside)};
}

} // namespace pcl::sedr

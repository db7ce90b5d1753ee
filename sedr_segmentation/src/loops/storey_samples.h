// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../curves/plan_curve.h"
#include "loop_samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl::sedr {

/** @brief A curve and the place on it from which it is followed both ways. */
struct SeededCurve {
  PlanCurve curve;
  Eigen::Vector2d seed = Eigen::Vector2d::Zero();

  /** @brief Returns half the length of a circle; a line has no end. */
  double half() const
  {
    return curve.isCircle() ? M_PI * curve.radius
                            : std::numeric_limits<double>::infinity();
  }

  /** @brief Returns how far along the curve from the seed a place is, metres. */
  double along(const Eigen::Vector2d& p) const
  {
    if (!curve.isCircle())
      return (p - seed).dot(curve.direction);
    return curve.radius * std::remainder(angleOf(p) - angleOf(seed), 2 * M_PI);
  }

  /** @brief Returns the place of the curve so far along it from the seed. */
  Eigen::Vector2d at(double s) const
  {
    if (!curve.isCircle())
      return curve.project(seed) + s * curve.direction;
    const double angle = angleOf(seed) + s / curve.radius;
    return curve.point +
           curve.radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }

private:
  double angleOf(const Eigen::Vector2d& p) const
  {
    return std::atan2(p.y() - curve.point.y(), p.x() - curve.point.x());
  }
};

/** @brief Numbered places in plan, found along curves. */
class NumberedPlaces {
public:
  static constexpr double step = 0.5; ///< metres: curves are followed in steps

  /** @brief Numbers the places as they are given. */
  explicit NumberedPlaces(const std::vector<Eigen::Vector2d>& places)
      : points_(places, step)
  {}

  /** @brief Follows a curve both ways from its seed as long as there is evidence of it.
   * @param reach metres; places farther from the curve are left out
   * @param gap metres; the curve ends so far beyond the last evidence
   * @param visit takes the number of a place and how far along the curve it is, and
   * returns whether it is evidence */
  template <typename Visit>
  void follow(const SeededCurve& curve, double reach, double gap, Visit visit) const
  {
    const double radius = std::hypot(reach, step / 2);
    for (const int side : {1, -1}) {
      double last = 0;
      for (int k = side > 0 ? 0 : 1;
           k * step < std::min(last + gap, curve.half() + step); ++k)
        points_.forEachIndexWithin(
            curve.at(side * k * step), radius, [&](std::size_t i) {
              const Eigen::Vector2d& p = points_.all()[i];
              const double s = curve.along(p);
              if (std::lround(s / step) == side * k &&
                  curve.curve.distance(p) < reach &&
                  visit(static_cast<std::uint32_t>(points_.given(i)), s))
                last = std::max(last, std::abs(s));
            });
    }
  }

private:
  PlanPoints points_;
};

/** @brief The samples of all contours of a storey, numbered through. */
class StoreySamples {
public:
  /** @param contours with their surfaces; must outlive this */
  explicit StoreySamples(const std::vector<LoopContour>& contours);

  std::size_t size() const { return samples_.size(); }
  const LoopSample& operator[](std::size_t i) const { return *samples_[i]; }

  /** @brief Returns the table of areas of a sample. */
  const float* areas(std::size_t i) const { return areas_[i]; }

  /** @brief Returns the contour of a sample. */
  std::size_t contourOf(std::size_t i) const { return contour_[i]; }

  /** @brief Returns the number of the first sample of a contour. */
  std::size_t firstOf(std::size_t contour) const { return first_[contour]; }

  /** @brief Returns the samples as places on the contours. */
  const NumberedPlaces& places() const { return places_; }

  /** @brief Returns the samples as places on surfaces, where they were seen. */
  const NumberedPlaces& anchors() const { return anchors_; }

private:
  std::vector<const LoopSample*> samples_;
  std::vector<const float*> areas_;
  std::vector<std::size_t> contour_; ///< of each sample
  std::vector<std::size_t> first_;   ///< of each contour
  NumberedPlaces places_;
  NumberedPlaces anchors_;
};

} // namespace pcl::sedr

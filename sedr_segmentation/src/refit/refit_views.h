// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../curves/quarter_turns.h"

#include "../curves/curve_adjustment.h"
#include "sedr_filters/src/base/plane_fit.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl::sedr {

// Views of points from a fixed surface: distance(p), signed, metres; row(p), its
// negative derivative by each parameter; patch(row, place), the patch number for a
// `place` of Sightings.

/** @brief Patch grid of a vertical surface: `count` along it, rows from the top down.
 */
struct PatchColumns {
  double width = 0; ///< metres
  std::size_t count = 0;

  std::size_t patch(double along, std::size_t row) const
  {
    const auto x = static_cast<std::size_t>(std::max(0.0, along / width));
    return row * count + std::min(count - 1, x);
  }
};

struct LineView {
  MeasuredCurve line;
  double reach = 0; ///< half of its length, metres
  PatchColumns columns;

  double distance(const Eigen::Vector3d& p) const
  {
    return (p.head<2>() - line.curve.point).dot(leftOf(line.curve.direction));
  }

  Eigen::Vector3d row(const Eigen::Vector3d& p) const
  {
    return {1, (p.head<2>() - line.pivot).dot(line.curve.direction), 0};
  }

  /** @brief Metres along the line, of the point of a row. */
  double along(const Eigen::Vector3d& row) const { return row[1] + reach; }

  std::size_t patch(const Eigen::Vector3d& row, std::size_t place) const
  {
    return columns.patch(along(row), place);
  }
};

struct CircleView {
  PlanCurve circle;
  PatchColumns columns;

  double distance(const Eigen::Vector3d& p) const
  {
    return (p.head<2>() - circle.point).norm() - circle.radius;
  }

  Eigen::Vector3d row(const Eigen::Vector3d& p) const
  {
    Eigen::Vector3d row;
    row << (p.head<2>() - circle.point).normalized(), 1;
    return row;
  }

  double along(const Eigen::Vector3d& row) const
  {
    return quarterTurns(row.x(), row.y()) * M_PI / 2 * circle.radius;
  }

  std::size_t patch(const Eigen::Vector3d& row, std::size_t place) const
  {
    return columns.patch(along(row), place);
  }
};

struct SlabView {
  PlanSlab slab;
  Eigen::Vector2d middle;

  double distance(const Eigen::Vector3d& p) const
  {
    return distanceAbove(slab, p.cast<float>());
  }

  Eigen::Vector3d row(const Eigen::Vector3d& p) const
  {
    return {1, p.x() - middle.x(), p.y() - middle.y()};
  }

  std::size_t patch(const Eigen::Vector3d&, std::size_t place) const { return place; }
};

} // namespace pcl::sedr

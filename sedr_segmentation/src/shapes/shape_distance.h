// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shape_fit.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief A row of at most `row_size` points or of values of theirs, one array each
 * of x, y and z: arithmetic takes several at once. */
constexpr std::size_t row_size = 64;
using ShapeValues =
    Eigen::Array<double, Eigen::Dynamic, 1, 0, static_cast<int>(row_size), 1>;

struct PointRow {
  std::array<ShapeValues, 3> at;

  Eigen::Index size() const { return at[0].size(); }
};

/** @brief Returns points in rows, in their order. O(n). */
std::vector<PointRow> rowsOf(const std::vector<Eigen::Vector3d>& points);

/** @brief Distances of points from a slab, as distanceOf(). */
void distancesOf(const PlanSlab& slab, const PointRow& points, ShapeValues& distance);

/** @brief Which of a shape's numbers each of seven quantities grows with; -1: none.
 * Of a plane: its slopes along x and y, and its height. Of a curve: its centre along
 * the axis and to the left of that, the height of its crown, on which a shallow vault's
 * radius hardly depends, the direction of the axis, and the inverses of `along`,
 * `across` and `up`. */
const std::array<int, 7>& numbersOf(ShapeKind kind);

/** @brief Distances of points from a shape, and how they grow with its numbers. */
class ShapeDistance {
public:
  /** @param about the place that a plane's numbers refer to, metres */
  ShapeDistance(ShapeKind kind, const PlanSlab& slab, const Eigen::Vector3d& about);

  /** @brief As distanceOf(), of each point. */
  void of(const PointRow& points, ShapeValues& distance) const;

  /** @brief The same, and the derivatives of the distances by each number, as many as
   * parametersOf() tells. */
  void of(const PointRow& points,
          ShapeValues& distance,
          std::array<ShapeValues, 7>& growth) const;

private:
  /** @brief Points in the frame of a curve. */
  struct Places {
    std::array<ShapeValues, 3> local; ///< metres: along the axis, to its left, up
    std::array<ShapeValues, 3>
        unit; ///< where the curve is the unit sphere, or cylinder
    std::array<ShapeValues, 3> slope; ///< how the square of `out` grows, halved
    ShapeValues out;                  ///< of the unit places from the middle
    ShapeValues square;               ///< of the slope's length
  };

  void placesOf(const PointRow& points, Places& places, ShapeValues& distance) const;

  ShapeKind kind_;
  Eigen::Vector3d about_;
  Eigen::Vector4d plane_;
  Eigen::Vector2d axis_ = Eigen::Vector2d::UnitX();
  Eigen::Vector2d aside_ = Eigen::Vector2d::UnitY();
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d inverse_ = Eigen::Vector3d::Zero(); ///< of the extents; 0: endless
};

} // namespace pcl::sedr

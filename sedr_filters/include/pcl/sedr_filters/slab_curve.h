// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief The shape of a floor or ceiling that is not a plane. */
enum class CurveKind {
  Cylinder,  ///< upper half of a horizontal cylinder: a barrel vault
  Ellipsoid, ///< upper half of an ellipsoid, axis vertical: dome, spherical cap
  Relief     ///< a grid of heights
};

/** @brief A height field in closed form or on a grid; lengths in metres, z up.
 *
 * @code
 * SlabCurve vault; // a barrel of 2 m radius whose axis runs along x, 1 m up
 * vault.base = 1;
 * vault.across = vault.up = 2;
 * vault.heightAt({5, 0}); // 3
 * @endcode */
struct SlabCurve {
  CurveKind kind = CurveKind::Cylinder;
  Eigen::Vector2d centre =
      Eigen::Vector2d::Zero(); ///< on the axis; relief: first height
  double base = 0;             ///< z of the axis or the centre
  Eigen::Vector2d axis =
      Eigen::Vector2d::UnitX(); ///< unit, in plan; direction of `along`
  double along = 0;             ///< of an ellipsoid: half extent along `axis`
  double across = 1;            ///< half extent across the axis: the radius
  double up = 1; ///< half extent upwards: the radius if the section is round

  double spacing = 1;          ///< of a relief: distance between its heights
  std::size_t columns = 0;     ///< of a relief: heights in a row, along x
  std::vector<double> heights; ///< of a relief: z values, row by row

  /** @brief Returns z at a place in plan. Beside a cylinder or ellipsoid it is `base`,
   * beside a relief the height of its nearest edge. */
  double heightAt(const Eigen::Vector2d& p) const;

  /** @brief Returns the gradient of heightAt(), limited to 1000 where vertical. */
  Eigen::Vector2d gradientAt(const Eigen::Vector2d& p) const;

  /** @brief Returns the distance of a point from the surface, positive above or
   * outside. To first order; exact for a round cylinder and a sphere. */
  double distanceAbove(const Eigen::Vector3d& p) const;

  /** @brief Returns the direction of the axis, radians, counter-clockwise from x. */
  double direction() const { return std::atan2(axis.y(), axis.x()); }

  void setDirection(double radians)
  {
    axis = Eigen::Vector2d(std::cos(radians), std::sin(radians));
  }

  /** @brief Returns the maximum z. */
  double highest() const;

  /** @brief Returns the number of heights of a relief in a column, along y. */
  std::size_t rows() const { return columns == 0 ? 0 : heights.size() / columns; }

  /** @brief Checks whether the cross-section is a circle. */
  bool isRound() const { return across == up; }

  /** @brief Checks whether the surface is a spherical cap. */
  bool isSphere() const
  {
    return kind == CurveKind::Ellipsoid && across == up && along == up;
  }

  bool isFinite() const;
};

/** @brief Returns the curve rotated by `angle` radians about the vertical axis through
 * the origin, counter-clockwise, then shifted. A relief is only shifted. */
SlabCurve moved(SlabCurve curve, double angle, const Eigen::Vector3d& shift);

} // namespace pcl::sedr

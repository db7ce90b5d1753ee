// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief What a floor or ceiling is that is no plane. */
enum class CurveKind {
  Cylinder,  ///< the upper half of one that lies: a barrel vault
  Ellipsoid, ///< the upper half of one that stands upright: a dome, a sphere's cap
  Relief     ///< heights on a grid
};

/** @brief A height field in closed form, or on a grid: lengths in metres, z up.
 *
 * @code
 * SlabCurve vault; // a barrel of 2 m radius whose axis runs along x, 1 m up
 * vault.base = 1;
 * vault.across = vault.up = 2;
 * vault.heightAt({5, 0}); // 3
 * @endcode */
struct SlabCurve {
  CurveKind kind = CurveKind::Cylinder;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero(); ///< on the axis; of a relief the
                                                    ///< place of its first height
  double base = 0;                                  ///< z of the axis or the centre
  Eigen::Vector2d axis = Eigen::Vector2d::UnitX();  ///< unit, in plan; of an ellipsoid
                                                    ///< the way of `along`
  double along = 0;  ///< of an ellipsoid: its half extent that way
  double across = 1; ///< half extent to the side: the radius
  double up = 1;     ///< half extent upwards: the radius where the section is round

  double spacing = 1;          ///< of a relief: between its heights
  std::size_t columns = 0;     ///< of a relief: heights in a row, along x
  std::vector<double> heights; ///< of a relief: row by row; z

  /** @brief z above a place in plan. Beside a cylinder or ellipsoid it is `base`,
   * beside a relief that of its nearest edge. */
  double heightAt(const Eigen::Vector2d& p) const;

  /** @brief How heightAt() grows along x and y; no steeper than 1000 where the surface
   * is upright. */
  Eigen::Vector2d gradientAt(const Eigen::Vector2d& p) const;

  /** @brief Distance of a point from the surface to first order, exact from a round
   * cylinder and a sphere; positive above or outside. */
  double distanceAbove(const Eigen::Vector3d& p) const;

  /** @brief Direction of the axis, radians, counter-clockwise from x. */
  double direction() const { return std::atan2(axis.y(), axis.x()); }

  void setDirection(double radians)
  {
    axis = Eigen::Vector2d(std::cos(radians), std::sin(radians));
  }

  /** @brief Its greatest z. */
  double highest() const;

  /** @brief Heights of a relief in a column, along y. */
  std::size_t rows() const { return columns == 0 ? 0 : heights.size() / columns; }

  /** @brief Whether the section across is a circle. */
  bool isRound() const { return across == up; }

  /** @brief Whether it is a cap of a sphere. */
  bool isSphere() const
  {
    return kind == CurveKind::Ellipsoid && across == up && along == up;
  }

  bool isFinite() const;
};

/** @brief The curve turned about the vertical by `angle` radians, counter-clockwise
 * about the origin, and shifted. A relief is only shifted. */
SlabCurve moved(SlabCurve curve, double angle, const Eigen::Vector3d& shift);

} // namespace sedr
} // namespace pcl

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief The closed forms that a facet may have, by increasing number of parameters.
 */
enum class ShapeKind { Level, Plane, Cylinder, Sphere, EllipticCylinder, Ellipsoid };

/** @brief Whether facets of a kind are planes, level or not. */
inline bool
isFlat(ShapeKind kind)
{
  return kind <= ShapeKind::Plane;
}

/** @brief How many numbers say what a facet of the kind is. */
int parametersOf(ShapeKind kind);

/** @brief Distance of a point from a slab to first order, positive above it. */
double distanceOf(const PlanSlab& slab, const Eigen::Vector3d& p);

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

template <int N>
Eigen::Matrix<double, N, 1>
meanOf(const std::vector<Eigen::Matrix<double, N, 1>>& points)
{
  Eigen::Matrix<double, N, 1> sum = Eigen::Matrix<double, N, 1>::Zero();
  for (const auto& p : points)
    sum += p;
  return sum / static_cast<double>(points.size());
}

/** @brief The plane through a place that rises by `slope` along x and y. */
PlanSlab planeThrough(const Eigen::Vector3d& place, const Eigen::Vector2d& slope);

/** @brief The plane of least squares in z. At least three points. */
PlanSlab fitPlane(const std::vector<Eigen::Vector3d>& points);

/** @brief 1, x, y, xx, xy, yy: of a place, or what each counts in a height. */
using QuadraticTerms = Eigen::Matrix<double, 6, 1>;
QuadraticTerms quadraticTerms(const Eigen::Vector2d& p);

/** @brief The surface of least squares in z that may tilt and bend. */
QuadraticTerms fitQuadratic(const std::vector<Eigen::Vector3d>& points);

/** @brief A shape through points that are all of it, roughly: a start for
 * refineShape().
 *
 * Cylinders are looked for along the direction in which the points curve least, and
 * along `directions`.
 * @return a slab; that of fitPlane() where the points do not curve as the kind does */
PlanSlab startShape(ShapeKind kind,
                    const std::vector<Eigen::Vector3d>& points,
                    const std::vector<double>& directions);

/** @brief Least squares of distances by Tukey's biweight: what is farther than 4.7
 * `deviation` counts for nothing. Gauss and Newton's way, damped.
 * @param[in,out] slab of the kind; where the fit fails it stays
 * @param settled share of the costs by which the last step lowers them */
void refineShape(ShapeKind kind,
                 const std::vector<Eigen::Vector3d>& points,
                 double deviation,
                 PlanSlab& slab,
                 double settled = 1e-6);

} // namespace pcl::sedr

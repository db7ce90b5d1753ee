// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>

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

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A point of a surface with the unit normal of the side that is free. */
struct OrientedPoint {
  Eigen::Vector3f position; ///< metres
  Eigen::Vector3f normal;   ///< unit length
};

/** @brief What pcl::Poisson is run with; see StructuralPoisson for the meaning of the
 * values. */
struct PoissonParameters {
  int depth = 9;
  int min_depth = 5;
  int solver_divide = 8;
  int iso_divide = 8;
  float point_weight = 4;
  float scale = 1.1f;
  float samples_per_node = 1;
  int threads = 1;
};

/** @brief Runs a fresh pcl::Poisson on the points.
 *
 * @param points finite, with unit normals; at least three
 * @param parameters must be in range: depth 2 to 14, the others above zero
 * @param mesh the surface, as pcl::Poisson leaves it; empty on failure
 * @param complaints how many lines pcl::Poisson would have printed
 * @return an empty string, or why there is no surface
 *
 * Runs of several threads of a process wait for one another: the octree's allocator is
 * shared. pcl::Poisson repeats its result to the bit with one thread only. */
std::string solvePoisson(const std::vector<OrientedPoint>& points,
                         const PoissonParameters& parameters,
                         TriangleMesh& mesh,
                         std::size_t& complaints);

/** @brief Typical distance between neighbouring points of a surface, metres: the side
 * of the square that each has for itself, median over the area, from at most 4000 of
 * the points. Zero for fewer than 10 points. O(n log n). */
double measureSpacing(const std::vector<OrientedPoint>& points);

} // namespace sedr
} // namespace pcl

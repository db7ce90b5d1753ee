// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace pcl::sedr {

/** @brief Eigenvalues of a symmetric matrix, ascending, and their unit vectors, one a
 * column. */
template <int N>
struct SymmetricEigen {
  Eigen::Matrix<double, N, 1> values;
  Eigen::Matrix<double, N, N> vectors;
};

/** @brief Decomposes a symmetric matrix; compiled once, since Eigen's solver is large.
 */
SymmetricEigen<2> symmetricEigen(const Eigen::Matrix2d& matrix);
SymmetricEigen<3> symmetricEigen(const Eigen::Matrix3d& matrix);

} // namespace pcl::sedr

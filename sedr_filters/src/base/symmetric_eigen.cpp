// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/base/symmetric_eigen.h"

#include <Eigen/Eigenvalues>

namespace pcl::sedr {
namespace {

template <int N>
SymmetricEigen<N>
decomposed(const Eigen::Matrix<double, N, N>& matrix)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

} // namespace

SymmetricEigen<2>
symmetricEigen(const Eigen::Matrix2d& matrix)
{
  return decomposed<2>(matrix);
}

SymmetricEigen<3>
symmetricEigen(const Eigen::Matrix3d& matrix)
{
  return decomposed<3>(matrix);
}

} // namespace pcl::sedr

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/impl/parallel_voxel_grid.hpp>
#include <pcl/sedr_surface/impl/mesh_reconstruction.hpp>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <pcl/common/io.h>

#include <string>

namespace pcl {

template <typename PointT>
IndoorStructureReconstruction<PointT>::IndoorStructureReconstruction() = default;

template <typename PointT>
IndoorStructureReconstruction<PointT>::~IndoorStructureReconstruction() = default;

template <typename PointT>
bool
IndoorStructureReconstruction<PointT>::fail()
{
  return sedr::StageError::fail("IndoorStructureReconstruction",
                                model_.failed_stage + ": " + model_.problem);
}

template <typename PointT>
bool
IndoorStructureReconstruction<PointT>::findStructure()
{
  this->clearError();
  mesh_ = sedr::TriangleMesh();
  reset();
  if (source_ || thinning_)
    return findStructureOf(thinning_ ? nullptr : source_.get()) || fail();
  if (!this->initCompute())
    return refuse("no input cloud was set") || fail();
  std::string problem = sedr::indicesProblem(*indices_, input_->size());
  if (problem.empty() && !positions_.empty() && !this->fake_indices_)
    problem = "scan positions are of all points, but indices are set";
  PointCloud chosen;
  if (problem.empty() && !this->fake_indices_)
    pcl::copyPointCloud(*input_, *indices_, chosen);
  const sedr::CloudRows<PointT> rows(this->fake_indices_ ? *input_ : chosen);
  const bool is_done = problem.empty() ? findStructureOf(&rows) : refuse(problem);
  this->deinitCompute();
  return is_done || fail();
}

template <typename PointT>
bool
IndoorStructureReconstruction<PointT>::makeMesh()
{
  return StructureChain::makeMesh() || fail();
}

template <typename PointT>
bool
IndoorStructureReconstruction<PointT>::run()
{
  if (!findStructure() || !makeMesh())
    return false;
  mesh_ = meshInScanFrame();
  return true;
}

} // namespace pcl

#define PCL_INSTANTIATE_IndoorStructureReconstruction(T)                               \
  template class PCL_EXPORTS pcl::IndoorStructureReconstruction<T>;

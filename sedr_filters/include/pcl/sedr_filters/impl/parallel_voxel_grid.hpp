// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/common/centroid.h>
#include <pcl/common/io.h>
#include <pcl/conversions.h>
#include <pcl/impl/pcl_base.hpp>
#include <pcl/sedr_filters/impl/thinned_voxels.h>
#include <pcl/sedr_filters/parallel_voxel_grid.h>
#include <pcl/sedr_filters/point_types.h>

#include <boost/mpl/size.hpp>

#include <algorithm>
#include <map>
#include <utility>

namespace pcl {
namespace sedr {

/** @brief The accumulated fields of the points of a voxel. */
template <typename PointT>
class VoxelPoint {
  static constexpr bool has_room =
      pcl::traits::has_field<PointT, pcl::fields::room>::value;

public:
  void add(const PointT& point)
  {
    centroid_.add(point);
    if constexpr (has_room)
      ++rooms_[point.room];
  }

  /** @brief Returns the means and the most frequent room, the smallest of equally
   * frequent ones, as pcl::CentroidPoint does for `label` but not for `room`. */
  void get(PointT& mean) const
  {
    centroid_.get(mean);
    if constexpr (has_room)
      mean.room = std::max_element(
                      rooms_.begin(), rooms_.end(),
                      [](const auto& a, const auto& b) { return a.second < b.second; })
                      ->first;
  }

private:
  pcl::CentroidPoint<PointT> centroid_;
  std::map<std::uint32_t, std::size_t> rooms_;
};

template <typename PointT>
void
setPosition(PointT& point, const Eigen::Vector3f& position)
{
  point.x = position.x();
  point.y = position.y();
  point.z = position.z();
}

} // namespace sedr

template <typename PointT>
void
ParallelVoxelGrid<PointT>::clearResults()
{
  sedr::StageFilter<PointT>::clearResults();
  clearLayout();
}

template <typename PointT>
void
ParallelVoxelGrid<PointT>::filter(PointCloud& output)
{
  if (!input_ || this->use_indices_ || this->extract_removed_indices_) {
    sedr::StageFilter<PointT>::filter(output);
    return;
  }
  // pcl::Filter would first create the indices of all points.
  PointCloud thinned;
  thinCloud(nullptr, thinned);
  thinned.header = input_->header;
  thinned.sensor_origin_ = input_->sensor_origin_;
  thinned.sensor_orientation_ = input_->sensor_orientation_;
  output = std::move(thinned);
}

template <typename PointT>
bool
ParallelVoxelGrid<PointT>::validate(const pcl::Indices* indices)
{
  constexpr const char* name = "ParallelVoxelGrid";
  std::string problem = parameterProblem();
  if (problem.empty() && indices)
    problem = sedr::indicesProblem(*indices, input_->size());
  if (!problem.empty())
    return fail(name, problem);
  limited_field_ = pcl::PCLPointField();
  if (getFilterFieldName().empty())
    return true;
  std::vector<pcl::PCLPointField> fields;
  const int field = pcl::getFieldIndex<PointT>(getFilterFieldName(), fields);
  if (field < 0)
    return fail(name,
                "the points have no field '" + getFilterFieldName() + "' to filter by");
  limited_field_ = fields[static_cast<std::size_t>(field)];
  return true;
}

template <typename PointT>
bool
ParallelVoxelGrid<PointT>::isWithinLimits(std::size_t i) const
{
  if (getFilterFieldName().empty())
    return true;
  const auto* point = reinterpret_cast<const std::uint8_t*>(&(*input_)[i]);
  return passesLimits(point + limited_field_.offset, limited_field_.datatype);
}

template <typename PointT>
pcl::Indices
ParallelVoxelGrid<PointT>::indicesWithinLimits(const pcl::Indices* indices) const
{
  pcl::Indices within;
  const std::size_t n = indices ? indices->size() : input_->size();
  for (std::size_t k = 0; k < n; ++k) {
    const auto i = indices ? (*indices)[k] : static_cast<pcl::index_t>(k);
    if (isWithinLimits(static_cast<std::size_t>(i)))
      within.push_back(i);
  }
  return within;
}

template <typename PointT>
void
ParallelVoxelGrid<PointT>::averageFields(const sedr::ThinnedVoxels& voxels,
                                         const pcl::Indices* indices,
                                         PointCloud& output) const
{
  std::vector<sedr::VoxelPoint<PointT>> means(output.size());
  voxels.forEachPoint(
      sedr::PointView(*input_), indices,
      [&](std::size_t voxel, std::size_t i) { means[voxel].add((*input_)[i]); });
  voxels.forEachStretch([&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const Eigen::Vector3f exact(output[v].x, output[v].y, output[v].z);
      means[v].get(output[v]);
      sedr::setPosition(output[v], exact);
    }
  });
}

template <typename PointT>
void
ParallelVoxelGrid<PointT>::writeMeans(const sedr::ThinnedVoxels& voxels,
                                      PointCloud& output) const
{
  output.clear();
  output.reserve(voxels.size());
  voxels.takeMemory(output.points.data(), voxels.size() * sizeof(PointT));
  output.resize(voxels.size());
  if (!output.empty())
    voxels.writeMeans(&output[0].x, sizeof(PointT));
}

template <typename PointT>
void
ParallelVoxelGrid<PointT>::filter(const sedr::RowSource& source, PointCloud& output)
{
  this->startRun(output);
  const std::string problem = this->rowsProblem(source);
  if (problem.empty())
    writeMeans(this->thin(source), output);
  else
    fail("ParallelVoxelGrid", problem);
}

template <typename PointT>
bool
ParallelVoxelGrid<PointT>::thinCloud(const pcl::Indices* indices, PointCloud& output)
{
  this->startRun(output);
  if (!validate(indices))
    return false;
  const sedr::PointView points(*input_);
  const pcl::Indices* chosen = indices;
  pcl::Indices within;
  if (!getFilterFieldName().empty()) {
    within = indicesWithinLimits(indices);
    chosen = &within;
  }
  sedr::ThinnedVoxels voxels = this->thin(points, chosen);
  writeMeans(voxels, output);
  constexpr bool has_more_fields =
      boost::mpl::size<typename pcl::traits::fieldList<PointT>::type>::value > 3;
  const bool averages = has_more_fields && getDownsampleAllData();
  if (averages || this->extract_removed_indices_)
    voxels.sortPoints();
  if constexpr (has_more_fields)
    if (averages)
      averageFields(voxels, chosen, output);
  if (this->extract_removed_indices_)
    for (const auto i : *indices) {
      const auto at = static_cast<std::size_t>(i);
      if (!isWithinLimits(at) || !voxels.contains(points[at]))
        removed_indices_->push_back(i);
    }
  return true;
}

template <typename PointT>
void
ParallelVoxelGrid<PointT>::applyFilter(PointCloud& output)
{
  if (!thinCloud(indices_.get(), output))
    this->removeAll();
}

template <typename PointT>
std::vector<int>
ParallelVoxelGrid<PointT>::getNeighborCentroidIndices(
    const PointT& reference_point,
    const Eigen::MatrixXi& relative_coordinates) const
{
  const Eigen::Vector3i voxel =
      getGridCoordinates(reference_point.x, reference_point.y, reference_point.z);
  std::vector<int> neighbours;
  for (Eigen::Index n = 0; n < relative_coordinates.cols(); ++n)
    neighbours.push_back(
        getCentroidIndexAt(voxel + relative_coordinates.col(n).head<3>()));
  return neighbours;
}

} // namespace pcl

#define PCL_INSTANTIATE_ParallelVoxelGrid(T)                                           \
  template class PCL_EXPORTS pcl::ParallelVoxelGrid<T>;

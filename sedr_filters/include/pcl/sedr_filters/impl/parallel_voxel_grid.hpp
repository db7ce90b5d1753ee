// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/common/centroid.h>
#include <pcl/common/io.h>
#include <pcl/conversions.h>
#include <pcl/impl/pcl_base.hpp>
#include <pcl/sedr_filters/field_access.h>
#include <pcl/sedr_filters/parallel.h>
#include <pcl/sedr_filters/parallel_voxel_grid.h>
#include <pcl/sedr_filters/point_types.h>

#include <boost/mpl/size.hpp>

#include <algorithm>
#include <map>
#include <numeric>

namespace pcl {
namespace sedr {

/** @brief The most frequent room of some points, the smallest of equally frequent ones:
 * what pcl::CentroidPoint does with `label` but not with `room`. */
template <typename PointT>
void
majorityRoom(const pcl::PointCloud<PointT>& cloud,
             const pcl::index_t* first,
             const pcl::index_t* last,
             PointT& mean)
{
  if constexpr (pcl::traits::has_field<PointT, pcl::fields::room>::value) {
    std::map<decltype(mean.room), std::size_t> votes;
    for (const auto* i = first; i != last; ++i)
      ++votes[cloud[*i].room];
    mean.room =
        std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) {
          return a.second < b.second;
        })->first;
  }
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
bool
ParallelVoxelGrid<PointT>::selectPoints(pcl::Indices& selected)
{
  constexpr const char* name = "ParallelVoxelGrid";
  std::string problem = parameterProblem();
  if (problem.empty())
    problem = sedr::indicesProblem(*indices_, input_->size());
  if (!problem.empty())
    return fail(name, problem);
  if (getFilterFieldName().empty())
    return true;
  std::vector<pcl::PCLPointField> fields;
  const int field = pcl::getFieldIndex<PointT>(getFilterFieldName(), fields);
  if (field < 0)
    return fail(name,
                "the points have no field '" + getFilterFieldName() + "' to filter by");
  const auto& f = fields[static_cast<std::size_t>(field)];
  for (const auto i : *indices_) {
    const auto* point = reinterpret_cast<const std::uint8_t*>(&(*input_)[i]);
    if (passesLimits(sedr::readField(point + f.offset, f.datatype)))
      selected.push_back(i);
  }
  return true;
}

template <typename PointT>
PointT
ParallelVoxelGrid<PointT>::meanOf(const pcl::index_t* first,
                                  const pcl::index_t* last) const
{
  PointT mean;
  if constexpr (boost::mpl::size<typename pcl::traits::fieldList<PointT>::type>::value >
                3) {
    if (getDownsampleAllData()) {
      pcl::CentroidPoint<PointT> centroid;
      std::for_each(first, last, [&](pcl::index_t i) { centroid.add((*input_)[i]); });
      centroid.get(mean);
      sedr::majorityRoom(*input_, first, last, mean);
    }
  }
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  std::for_each(first, last, [&](pcl::index_t i) {
    const auto& p = (*input_)[i];
    sum += Eigen::Vector3d(p.x, p.y, p.z);
  });
  sum /= static_cast<double>(last - first);
  mean.x = static_cast<float>(sum.x());
  mean.y = static_cast<float>(sum.y());
  mean.z = static_cast<float>(sum.z());
  return mean;
}

template <typename PointT>
void
ParallelVoxelGrid<PointT>::applyFilter(PointCloud& output)
{
  this->startRun(output);
  pcl::Indices selected;
  if (!selectPoints(selected)) {
    this->removeAll();
    return;
  }
  const sedr::PointView points(*input_);
  const bool takes_all = getFilterFieldName().empty();
  auto partition = sedr::partitionVoxels(points, takes_all ? *indices_ : selected,
                                         inverseLeaf(), getNumberOfThreads());
  finishPartition(points, partition);

  output.resize(partition.size());
  constexpr std::size_t voxels_at_once = 4096;
  sedr::parallelBlocks(partition.size(), voxels_at_once, getNumberOfThreads(),
                       [&](std::size_t begin, std::size_t end) {
                         for (std::size_t v = begin; v < end; ++v)
                           output[v] =
                               meanOf(partition.order.data() + partition.begin[v],
                                      partition.order.data() + partition.begin[v + 1]);
                       });
  if (this->extract_removed_indices_)
    *removed_indices_ = removedIndices(*indices_, partition, input_->size());
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

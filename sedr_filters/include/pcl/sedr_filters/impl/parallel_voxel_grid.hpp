// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/common/io.h>
#include <pcl/sedr_filters/impl/pcl_bases.hpp>
#include <pcl/sedr_filters/parallel_voxel_grid.h>
#include <pcl/sedr_filters/point_types.h>

#include <utility>

namespace pcl {
namespace sedr {

/** @brief A cloud as a source of one piece. */
template <typename PointT>
class CloudRows : public RowSource {
public:
  explicit CloudRows(const pcl::PointCloud<PointT>& cloud)
      : cloud_(cloud)
  {}

  const std::vector<pcl::PCLPointField>& fields() const override { return fields_; }
  std::size_t rowSize() const override { return sizeof(PointT); }
  std::size_t size() const override { return cloud_.size(); }

  void forEachPiece(const std::function<bool(const Piece&)>& see) const override
  {
    see({reinterpret_cast<const std::uint8_t*>(cloud_.points.data()), 0, size()});
  }

private:
  const pcl::PointCloud<PointT>& cloud_;
  std::vector<pcl::PCLPointField> fields_ = pcl::getFields<PointT>();
};

} // namespace sedr

template <typename PointT>
void
ParallelVoxelGrid<PointT>::clearResults()
{
  sedr::StageFilter<PointT>::clearResults();
  strays_ = 0;
}

template <typename PointT>
bool
ParallelVoxelGrid<PointT>::thinInto(PointCloud& output,
                                    const sedr::RowSource& source,
                                    const pcl::Indices* indices,
                                    bool only_places)
{
  const auto make = [&output](std::size_t n) {
    output.resize(n);
    return reinterpret_cast<std::uint8_t*>(output.points.data());
  };
  const auto fields = pcl::getFields<PointT>();
  this->startRun(output);
  const std::string problem =
      this->thin(source, indices, {fields, sizeof(PointT), make, only_places},
                 this->extract_removed_indices_ && !only_places ? removed_indices_.get()
                                                                : nullptr);
  return problem.empty() || fail("ParallelVoxelGrid", problem);
}

template <typename PointT>
void
ParallelVoxelGrid<PointT>::filter(PointCloud& output)
{
  if (!input_ || this->use_indices_ || this->extract_removed_indices_) {
    sedr::StageFilter<PointT>::filter(output);
    return;
  }
  PointCloud thinned; // pcl::Filter would first list the indices of all points
  thinInto(thinned, sedr::CloudRows<PointT>(*input_), nullptr, false);
  thinned.header = input_->header;
  thinned.sensor_origin_ = input_->sensor_origin_;
  thinned.sensor_orientation_ = input_->sensor_orientation_;
  output = std::move(thinned);
}

template <typename PointT>
void
ParallelVoxelGrid<PointT>::filter(const sedr::RowSource& source, PointCloud& output)
{
  thinInto(output, source, nullptr, true);
}

template <typename PointT>
void
ParallelVoxelGrid<PointT>::applyFilter(PointCloud& output)
{
  if (!thinInto(output, sedr::CloudRows<PointT>(*input_),
                this->fake_indices_ ? nullptr : indices_.get(), false))
    this->removeAll();
}

} // namespace pcl

#define PCL_INSTANTIATE_ParallelVoxelGrid(T)                                           \
  template class PCL_EXPORTS pcl::ParallelVoxelGrid<T>;

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/ModelCoefficients.h>
#include <pcl/sedr_filters/stage_filter.h>

#include <Eigen/Core>

#include <cstddef>

namespace pcl {

/** @brief Completes a floor from the ceiling above it (paper, section 2.3.1): what
 * furniture hides is filled, what lies outside the rooms is removed.
 *
 * The input cloud holds floor, ceiling and details alike (z up, metres); the indices
 * are the floor (all points if none are set). The scope of the rooms is the square
 * cells in plan that hold ceiling or detail points. The output is the floor points
 * inside the scope, in their order, then for each cell of the scope without a floor
 * point the ceiling points of that cell, or else its detail points, moved to the floor.
 * These are copies of their sources with the new z, the normal up and the label of a
 * floor, where the type has such fields; cell by cell, then by index.
 *
 * Non-finite points span no cells and never reach the output; those of the floor are
 * among the removed indices, with the floor points outside the scope. No ceiling, no
 * floor point in the scope and no plane, a grid size that is not above 0, an index
 * beyond the cloud: PCL_ERROR, an empty output, all indices removed, and
 * getErrorMessage() says why. O(n log n).
 * @code
 * pcl::FloorProjectionRecovery<pcl::PointXYZ> recovery;
 * recovery.setInputCloud(scan);
 * recovery.setIndices(floor);
 * recovery.setCeilingIndices(ceiling);
 * recovery.filter(*whole_floor);
 * @endcode */
template <typename PointT>
class FloorProjectionRecovery : public sedr::StageFilter<PointT> {
public:
  using Ptr = shared_ptr<FloorProjectionRecovery<PointT>>;
  using ConstPtr = shared_ptr<const FloorProjectionRecovery<PointT>>;
  using PointCloud = typename Filter<PointT>::PointCloud;

  /** @param extract_removed_indices whether getRemovedIndices() is filled */
  explicit FloorProjectionRecovery(bool extract_removed_indices = false)
      : sedr::StageFilter<PointT>(extract_removed_indices)
  {
    filter_name_ = "FloorProjectionRecovery";
  }

  /** @brief The ceiling, indices into the input cloud. Must be set. */
  void setCeilingIndices(const sedr::StageIndices& ceiling)
  {
    ceiling_ = ceiling.get();
  }

  IndicesConstPtr getCeilingIndices() const { return ceiling_; }

  /** @brief The details of the ceiling, indices into the input cloud; null: none
   * (default). */
  void setDetailIndices(const sedr::StageIndices& detail) { detail_ = detail.get(); }

  IndicesConstPtr getDetailIndices() const { return detail_; }

  /** @brief Edge of a cell, metres, > 0 (default 0.05). */
  void setGridSize(double size) { grid_size_ = size; }

  double getGridSize() const { return grid_size_; }

  /** @brief The plane of the floor, a x + b y + c z + d = 0, to project onto; null
   * (default): level, at the mean height of the floor points in the scope. */
  void setFloorCoefficients(const ModelCoefficients::ConstPtr& plane)
  {
    plane_ = plane;
  }

  ModelCoefficients::ConstPtr getFloorCoefficients() const { return plane_; }

  /** @brief Of each output point of the last run the point of the input that it comes
   * from: first the floor points kept, then the sources of those projected. */
  const Indices& getProjectedIndices() const { return source_indices_; }

  /** @brief How many points, the last ones of the output, the last run projected. */
  std::size_t getNumberOfProjected() const { return number_of_projected_; }

protected:
  using Filter<PointT>::filter_name_;
  using Filter<PointT>::input_;
  using Filter<PointT>::indices_;
  using Filter<PointT>::removed_indices_;
  using sedr::StageFilter<PointT>::fail;

  void applyFilter(PointCloud& output) override;

  void clearResults() override;

private:
  bool validate();

  /** @brief The plane to project onto, its normal up and of unit length. */
  bool findPlane(const Indices& floor_in_scope, Eigen::Vector4d& plane);

  IndicesConstPtr ceiling_;
  IndicesConstPtr detail_;
  double grid_size_ = 0.05;
  ModelCoefficients::ConstPtr plane_;

  Indices source_indices_;
  std::size_t number_of_projected_ = 0;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_filters/impl/floor_projection_recovery.hpp>
#endif

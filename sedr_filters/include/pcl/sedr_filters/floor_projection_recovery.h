// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/ModelCoefficients.h>
#include <pcl/sedr_filters/impl/stage_filter.hpp>

#include <Eigen/Core>

#include <cstddef>

namespace pcl {

/** @brief Completes a floor from the ceiling above it (paper, section 2.3.1): fills
 * parts hidden by furniture and removes points outside the rooms.
 *
 * The input cloud holds floor, ceiling and details alike (z up, metres); the indices
 * are the floor (all points if none are set). The scope of the rooms is the set of
 * square cells in plan that hold ceiling or detail points. The output starts with the
 * floor points inside the scope, in input order. Then, for each cell of the scope
 * without a floor point, come its ceiling points, or else its detail points, moved to
 * the floor. They are copies with the new z, and with an upward normal and the floor
 * label where the type has them, ordered by cell, then by index.
 *
 * Non-finite points occupy no cells and never reach the output. The removed indices are
 * the non-finite floor points and the floor points outside the scope. A run fails
 * without a ceiling, with a grid size that is not above 0 or with an index beyond the
 * cloud. It also fails with neither a plane nor a floor point in the scope. Then
 * PCL_ERROR is printed, the output is empty, all indices are removed, and
 * getErrorMessage() gives the reason. O(n log n). */
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

  /** @brief Sets the ceiling, as indices into the input cloud. Required. */
  void setCeilingIndices(const sedr::StageIndices& ceiling)
  {
    ceiling_ = ceiling.get();
  }
  IndicesConstPtr getCeilingIndices() const { return ceiling_; }

  /** @brief Sets the details, as indices into the input cloud; null: none (default). */
  void setDetailIndices(const sedr::StageIndices& detail) { detail_ = detail.get(); }
  IndicesConstPtr getDetailIndices() const { return detail_; }

  /** @brief Sets the edge of a cell, metres, > 0 (default 0.05). */
  void setGridSize(double size) { grid_size_ = size; }
  double getGridSize() const { return grid_size_; }

  /** @brief Sets the floor plane to project onto, a x + b y + c z + d = 0. Null
   * (default): horizontal, at the mean height of the floor points in the scope. */
  void setFloorCoefficients(const ModelCoefficients::ConstPtr& plane)
  {
    plane_ = plane;
  }
  ModelCoefficients::ConstPtr getFloorCoefficients() const { return plane_; }

  /** @brief Returns the input index of each output point of the last run: first the
   * kept floor points, then the sources of the projected ones. */
  const Indices& getProjectedIndices() const { return source_indices_; }

  /** @brief Returns the number of projected points, the last of the output. */
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
  /** @brief Returns what is wrong with the input, as a sentence. */
  std::string problem() const;

  /** @brief Finds the plane to project onto, with a unit normal that points up.
   * @return why there is none, as a sentence; empty otherwise */
  std::string findPlane(const Indices& floor_in_scope, Eigen::Vector4d& plane) const;

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

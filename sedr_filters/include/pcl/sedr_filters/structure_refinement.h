// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/stage_filter.h>

#include <cstdint>
#include <vector>

namespace pcl {

/** @brief Moves the points of ceiling, floor and walls onto the fitted model (paper,
 * section 2.4): slab points to their plane, wall and column points to their line or
 * circle in x and y while z stays, detail points to their underside or riser. Frame: z
 * up, metres.
 *
 * What a point is comes from setLabels() and setRooms(), or from the fields `label` and
 * `room` of the point type. The output holds the points that belong to the structure,
 * in input order, with the exact normal into the room, label and room where the point
 * type has such fields; all other points (label 0, no room, farther than the maximum
 * distance, not finite) are removed. O(n e) for n points and e elements of a room.
 *
 * No input, no plan, a distance that is not above 0, an index beyond the cloud, labels
 * or rooms of another number than the points: PCL_ERROR, an empty output, all indices
 * removed, and getErrorMessage() says why.
 * @code
 * pcl::StructureRefinement<pcl::PointStructure> refinement;
 * refinement.setInputCloud(labelled);
 * refinement.setFloorplan(plan);
 * refinement.filter(*refined);
 * @endcode */
template <typename PointT>
class StructureRefinement : public sedr::PlanFilter<PointT> {
public:
  using Ptr = shared_ptr<StructureRefinement<PointT>>;
  using ConstPtr = shared_ptr<const StructureRefinement<PointT>>;
  using PointCloud = typename Filter<PointT>::PointCloud;

  /** @param extract_removed_indices whether getRemovedIndices() is filled */
  explicit StructureRefinement(bool extract_removed_indices = false)
      : sedr::PlanFilter<PointT>(extract_removed_indices)
  {
    this->filter_name_ = "StructureRefinement";
  }

  /** @brief The farthest a point may move, metres, > 0; one farther off its surface is
   * removed. Default 0.15. */
  void setMaximumDistance(double distance) { maximum_distance_ = distance; }
  double getMaximumDistance() const { return maximum_distance_; }

  /** @brief Threads, 0 for all processors. Default 0. The result does not depend on it.
   */
  void setNumberOfThreads(unsigned int threads = 0) { threads_ = threads; }
  unsigned int getNumberOfThreads() const { return threads_; }

protected:
  void applyFilter(PointCloud& output) override;

private:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;
  using sedr::PlanFilter<PointT>::plan_;
  using sedr::PlanFilter<PointT>::sources_;
  using sedr::PlanFilter<PointT>::surface_points_;
  using sedr::PlanFilter<PointT>::fail;

  /** @brief Checks all that was set, and fills labels and rooms where none were. */
  bool validate(std::vector<std::uint32_t>& labels, std::vector<std::uint32_t>& rooms);

  double maximum_distance_ = 0.15;
  unsigned int threads_ = 0;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_filters/impl/structure_refinement.hpp>
#endif

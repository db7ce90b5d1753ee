// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/impl/stage_filter.hpp>

namespace pcl {

/** @brief Moves the points of ceiling, floor and walls onto the fitted model (paper,
 * section 2.4). Slab points move to their plane, detail points to their underside or
 * riser. Wall and column points move to their line or circle in x and y and keep z.
 * Frame: z up, metres.
 *
 * Labels and rooms come from setLabels() and setRooms(), or from the fields `label` and
 * `room` of the point type. The output holds the points of the structure in input
 * order. Normal (exact, into the room), label and room are set where the point type has
 * them. All other points (label 0, no room, beyond the maximum distance, not finite)
 * are removed. O(n e) for n points and e elements of a room.
 *
 * A run fails without input or plan, with a distance not above 0, an index beyond the
 * cloud, or labels or rooms that differ in number from the points. Then PCL_ERROR is
 * printed, the output is empty, all indices are removed, and getErrorMessage() gives
 * the reason. */
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

  /** @brief Sets the maximum distance that a point may move, metres, > 0; points
   * farther off their surface are removed. Default 0.15. */
  void setMaximumDistance(double distance) { maximum_distance_ = distance; }
  double getMaximumDistance() const { return maximum_distance_; }

protected:
  void applyFilter(PointCloud& output) override;

private:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;
  using sedr::PlanFilter<PointT>::plan_;
  using sedr::PlanFilter<PointT>::sources_;
  using sedr::PlanFilter<PointT>::surface_points_;

  double maximum_distance_ = 0.15;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_filters/impl/structure_refinement.hpp>
#endif

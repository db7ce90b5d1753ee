// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/plan_surfaces.h>
#include <pcl/sedr_filters/stage_filter.h>

#include <cstdint>
#include <memory>
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
class StructureRefinement : public sedr::StageFilter<PointT> {
public:
  using Ptr = shared_ptr<StructureRefinement<PointT>>;
  using ConstPtr = shared_ptr<const StructureRefinement<PointT>>;
  using PointCloud = typename Filter<PointT>::PointCloud;

  /** @param extract_removed_indices whether getRemovedIndices() is filled */
  explicit StructureRefinement(bool extract_removed_indices = false)
      : sedr::StageFilter<PointT>(extract_removed_indices)
  {
    this->filter_name_ = "StructureRefinement";
  }

  /** @brief The model; its rooms' ids are the values of `room`. Needed. */
  void setFloorplan(const std::shared_ptr<const sedr::Floorplan>& plan)
  {
    plan_ = plan;
  }
  std::shared_ptr<const sedr::Floorplan> getFloorplan() const { return plan_; }

  /** @brief sedr::StructureLabel of every point of the cloud; empty: from the point
   * type. */
  void setLabels(std::vector<std::uint32_t> labels) { labels_ = std::move(labels); }

  /** @brief Room of every point of the cloud, 0 none; empty: from the point type. */
  void setRooms(std::vector<std::uint32_t> rooms) { rooms_ = std::move(rooms); }

  /** @brief The farthest a point may move, metres, > 0; one farther off its surface is
   * removed. Default 0.15. */
  void setMaximumDistance(double distance) { maximum_distance_ = distance; }
  double getMaximumDistance() const { return maximum_distance_; }

  /** @brief Threads, 0 for all processors. Default 0. The result does not depend on it.
   */
  void setNumberOfThreads(unsigned int threads = 0) { threads_ = threads; }
  unsigned int getNumberOfThreads() const { return threads_; }

  /** @brief Index in the input cloud of every point of the output. */
  const Indices& getSourceIndices() const { return sources_; }

  /** @brief Position, normal, label and room of every point of the output, in double
   * precision. */
  const std::vector<sedr::SurfacePoint>& getSurfacePoints() const
  {
    return surface_points_;
  }

protected:
  void applyFilter(PointCloud& output) override;

  void clearResults() override;

private:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;
  using Filter<PointT>::removed_indices_;
  using Filter<PointT>::extract_removed_indices_;
  using sedr::StageFilter<PointT>::fail;

  /** @brief Checks all that was set, and fills labels and rooms where none were. */
  bool validate(std::vector<std::uint32_t>& labels, std::vector<std::uint32_t>& rooms);

  std::shared_ptr<const sedr::Floorplan> plan_;
  std::vector<std::uint32_t> labels_;
  std::vector<std::uint32_t> rooms_;
  double maximum_distance_ = 0.15;
  unsigned int threads_ = 0;
  Indices sources_;
  std::vector<sedr::SurfacePoint> surface_points_;
};

} // namespace pcl

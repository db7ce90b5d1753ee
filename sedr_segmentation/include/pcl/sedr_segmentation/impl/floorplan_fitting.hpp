// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/impl/pcl_bases.hpp>
#include <pcl/sedr_filters/impl/structure_fields.hpp>
#include <pcl/sedr_segmentation/floorplan_fitting.h>

#include <string>

namespace pcl {
namespace sedr {

/** @brief Input of FloorplanFitting; a null pointer means no points. */
struct PlanInput {
  PointView points;
  const pcl::Indices& indices;
  const pcl::IndicesConstPtr& ceiling;
  const pcl::IndicesConstPtr& floor;
  const pcl::IndicesConstPtr& details;
  const pcl::IndicesConstPtr& walls;
  std::vector<std::uint32_t> rooms; ///< of each point; empty: one room
  const std::map<std::uint32_t, HiddenCells>& hidden; ///< of each room
  const std::vector<PointOwner>& owners;   ///< of each point; empty: to be found
  PointView raw;                           ///< points before thinning, or empty
  const pcl::IndicesConstPtr& raw_indices; ///< null: all
};

/** @brief Runs FloorplanFitting on the coordinates of a cloud.
 * @return the reason for a failure, a sentence; empty on success */
std::string fitFloorplan(const PlanInput& input,
                         const RoomFitParameters& parameters,
                         Floorplan& plan,
                         std::vector<PlanWarning>& warnings,
                         std::vector<FittedBoundary>& boundaries,
                         std::vector<WallNoise>& noise);

/** @brief Returns the raw points that the fit uses, transformed by the map. */
std::shared_ptr<const std::vector<Eigen::Vector3f>>
movedPoints(const PointView& raw,
            const pcl::IndicesConstPtr& indices,
            unsigned threads,
            const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& map);

} // namespace sedr

template <typename PointT>
void
FloorplanFitting<PointT>::moveRawPoints(
    const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& map)
{
  if (raw_)
    setRawPoints(sedr::movedPoints(raw_(), raw_indices_, parameters_.threads, map));
}

template <typename PointT>
bool
FloorplanFitting<PointT>::segment(sedr::Floorplan& plan)
{
  plan.rooms.clear();
  warnings_.clear();
  boundaries_.clear();
  noise_.clear();
  this->clearError();
  if (!this->initCompute())
    return fail("FloorplanFitting", "no input cloud was set");
  if (!rooms_.empty() && rooms_.size() != input_->size()) {
    this->deinitCompute();
    return fail("FloorplanFitting", "the cloud has " + std::to_string(input_->size()) +
                                        " points, but rooms of " +
                                        std::to_string(rooms_.size()) + " were set");
  }
  if (!owners_.empty() && owners_.size() != input_->size()) {
    this->deinitCompute();
    return fail("FloorplanFitting", "the cloud has " + std::to_string(input_->size()) +
                                        " points, but owners of " +
                                        std::to_string(owners_.size()) + " were set");
  }
  const std::string problem = sedr::fitFloorplan(
      {sedr::PointView(*input_), *indices_, ceiling_, floor_, details_, walls_,
       rooms_.empty() ? sedr::roomsOf(*input_) : rooms_, hidden_, owners_,
       raw_ ? raw_() : sedr::PointView(), raw_indices_},
      parameters_, plan, warnings_, boundaries_, noise_);
  this->deinitCompute();
  return problem.empty() || fail("FloorplanFitting", problem);
}

} // namespace pcl

#define PCL_INSTANTIATE_FloorplanFitting(T)                                            \
  template class PCL_EXPORTS pcl::FloorplanFitting<T>;

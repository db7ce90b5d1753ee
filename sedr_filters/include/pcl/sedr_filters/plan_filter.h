// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/plan_surfaces.h>
#include <pcl/sedr_filters/stage_filter.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Base of the stages that move labelled points onto a floor plan: the plan, the
 * points' labels and rooms, and where each point of the output comes from and lies. */
template <typename PointT>
class PlanFilter : public StageFilter<PointT> {
public:
  /** @brief The model; its rooms' ids are the values of `room`. Needed. */
  void setFloorplan(const std::shared_ptr<const Floorplan>& plan) { plan_ = plan; }
  std::shared_ptr<const Floorplan> getFloorplan() const { return plan_; }

  /** @brief sedr::StructureLabel of every point of the cloud; empty: from the point
   * type. */
  void setLabels(std::vector<std::uint32_t> labels) { labels_ = std::move(labels); }

  /** @brief Room of every point of the cloud, 0 none; empty: from the point type. */
  void setRooms(std::vector<std::uint32_t> rooms) { rooms_ = std::move(rooms); }

  /** @brief Index in the input cloud of every point of the output, -1 for one that is
   * new. */
  const Indices& getSourceIndices() const { return sources_; }

  /** @brief Position, normal, label and room of every point of the output, in double
   * precision. */
  const std::vector<SurfacePoint>& getSurfacePoints() const { return surface_points_; }

protected:
  explicit PlanFilter(bool extract_removed_indices)
      : StageFilter<PointT>(extract_removed_indices)
  {}

  void clearResults() override
  {
    StageFilter<PointT>::clearResults();
    sources_.clear();
    surface_points_.clear();
  }

  /** @brief Lists the removed indices, where they are asked for.
   * @param on_plan those of the indices, in their order, that lie on the plan
   * @param isKept whether the k-th of them stays, by k */
  template <typename IsKept>
  void removeAllBut(const Indices& on_plan, IsKept isKept)
  {
    if (!this->extract_removed_indices_)
      return;
    std::size_t next = 0;
    for (const auto i : *this->indices_) {
      const bool is_on_plan = next < on_plan.size() && on_plan[next] == i;
      if (!is_on_plan || !isKept(next))
        this->removed_indices_->push_back(i);
      next += is_on_plan ? 1 : 0;
    }
  }

  std::shared_ptr<const Floorplan> plan_;
  std::vector<std::uint32_t> labels_;
  std::vector<std::uint32_t> rooms_;
  Indices sources_;
  std::vector<SurfacePoint> surface_points_;
};

} // namespace sedr
} // namespace pcl

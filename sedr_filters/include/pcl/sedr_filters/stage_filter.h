// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/filters/filter.h>
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/stage_error.h>
#include <pcl/sedr_filters/structure_label.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Base of the stages that write a cloud: a filter that fails aloud.
 *
 * pcl::Filter::filter() does nothing at all without an input cloud; here that is a
 * failed run like any other: getErrorMessage() gives the reason, the output is empty,
 * the results of earlier runs are gone. A class that derives from it clears its
 * results, error and removed indices in clearResults(), and calls removeAll() where it
 * gives up. */
template <typename PointT>
class StageFilter : public Filter<PointT>, public StageError {
public:
  using PointCloud = typename Filter<PointT>::PointCloud;

  /** @brief Writes the result to `output`, which may be the input. */
  void filter(PointCloud& output)
  {
    if (this->input_) {
      Filter<PointT>::filter(output);
      return;
    }
    clearResults();
    fail(this->filter_name_.c_str(), "no input cloud was set");
    output.clear();
  }

protected:
  explicit StageFilter(bool extract_removed_indices)
      : Filter<PointT>(extract_removed_indices)
  {}

  /** @brief Clears all that a run leaves in the object: a derived class clears its own
   * results and calls this. */
  virtual void clearResults()
  {
    clearError();
    this->removed_indices_->clear();
  }

  /** @brief Begins a run: no results, an empty and dense output. */
  void startRun(PointCloud& output)
  {
    clearResults();
    output.clear();
    output.height = 1;
    output.is_dense = true;
  }

  /** @brief Ends a failed run: all indices that the cloud has are removed, where they
   * are asked for. */
  void removeAll()
  {
    if (this->extract_removed_indices_)
      *this->removed_indices_ = indicesInRange(*this->indices_, this->input_->size());
  }
};

/** @brief Base of the stages that move labelled points onto a floor plan: the plan, the
 * points' labels and rooms, and where each point of the output comes from and lies. */
template <typename PointT>
class PlanFilter : public StageFilter<PointT> {
public:
  /** @brief The model; its rooms' ids are the values of `room`. Needed. */
  void setFloorplan(const std::shared_ptr<const Floorplan>& plan) { plan_ = plan; }

  /** @brief As above; the plan is moved or copied. */
  void setFloorplan(Floorplan plan)
  {
    plan_ = std::make_shared<const Floorplan>(std::move(plan));
  }

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

  /** @brief sedr::StructureLabel of every point of the output: what setLabels() of the
   * next stage takes. O(n). */
  std::vector<std::uint32_t> getLabels() const
  {
    std::vector<std::uint32_t> labels;
    for (const SurfacePoint& point : surface_points_)
      labels.push_back(static_cast<std::uint32_t>(point.label));
    return labels;
  }

  /** @brief Room of every point of the output: what setRooms() of the next stage takes.
   * O(n). */
  std::vector<std::uint32_t> getRooms() const
  {
    std::vector<std::uint32_t> rooms;
    for (const SurfacePoint& point : surface_points_)
      rooms.push_back(point.room);
    return rooms;
  }

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

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/filters/filter.h>
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/impl/refinement.h>
#include <pcl/sedr_filters/impl/stage_error.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief Base of the stages that write a cloud: a filter that reports its failures.
 *
 * pcl::Filter::filter() silently does nothing without an input cloud. Here that is a
 * failed run: getErrorMessage() gives the reason, the output is empty, and earlier
 * results are cleared. A derived class clears its results, error and removed indices in
 * clearResults(), and ends a run that fails by failRun(). */
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

  /** @brief Clears all results of a run. Overrides clear their own results and call
   * this. */
  virtual void clearResults()
  {
    clearError();
    this->removed_indices_->clear();
  }

  /** @brief Starts a run: clears all results; the output becomes empty and dense. */
  void startRun(PointCloud& output)
  {
    clearResults();
    output.clear();
    output.height = 1;
    output.is_dense = true;
  }

  /** @brief Ends a run that fails for this reason. */
  void failRun(const std::string& problem)
  {
    fail(this->filter_name_.c_str(), problem);
    removeAll();
  }

  /** @brief Makes all valid indices removed ones, if these are requested. */
  void removeAll()
  {
    if (this->extract_removed_indices_)
      *this->removed_indices_ = indicesInRange(*this->indices_, this->input_->size());
  }
};

/** @brief Base of the stages that move labelled points onto a floor plan. Holds the
 * plan, labels and rooms, and the source and position of each output point. */
template <typename PointT>
class PlanFilter : public StageFilter<PointT> {
public:
  /** @brief Sets the floor plan, whose room ids are the values of `room`. Required. */
  void setFloorplan(const std::shared_ptr<const Floorplan>& plan) { plan_ = plan; }

  /** @brief Sets the floor plan, which is moved or copied. */
  void setFloorplan(Floorplan plan)
  {
    plan_ = std::make_shared<const Floorplan>(std::move(plan));
  }

  std::shared_ptr<const Floorplan> getFloorplan() const { return plan_; }

  /** @brief Sets the sedr::StructureLabel of every input point; empty: taken from the
   * point type. */
  void setLabels(std::vector<std::uint32_t> labels) { labels_ = std::move(labels); }

  /** @brief Sets the room of every input point, 0 none; empty: from the point type. */
  void setRooms(std::vector<std::uint32_t> rooms) { rooms_ = std::move(rooms); }

  /** @brief Sets the number of threads, 0 for all processors (default). The result does
   * not depend on it. */
  void setNumberOfThreads(unsigned int threads = 0) { threads_ = threads; }
  unsigned int getNumberOfThreads() const { return threads_; }

  /** @brief Returns the input index of every output point, -1 for new points. */
  const Indices& getSourceIndices() const { return sources_; }

  /** @brief Returns position, normal, label and room of every output point, in double
   * precision. */
  const std::vector<SurfacePoint>& getSurfacePoints() const { return surface_points_; }

  /** @brief Returns the sedr::StructureLabel of every output point, as setLabels() of
   * the next stage expects. O(n). */
  std::vector<std::uint32_t> getLabels() const
  {
    std::vector<std::uint32_t> labels;
    for (const SurfacePoint& point : surface_points_)
      labels.push_back(static_cast<std::uint32_t>(point.label));
    return labels;
  }

  /** @brief Returns the room of every output point, as setRooms() of the next stage
   * expects. O(n). */
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

  /** @brief Fills the removed indices, if these are requested.
   * @param on_plan the input indices that lie on the plan, in input order
   * @param isKept whether on_plan[k] is kept, by k */
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
  unsigned int threads_ = 0;
  Indices sources_;
  std::vector<SurfacePoint> surface_points_;
};

} // namespace pcl::sedr

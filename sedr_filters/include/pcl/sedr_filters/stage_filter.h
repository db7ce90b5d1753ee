// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/filters/filter.h>
#include <pcl/sedr_filters/stage_error.h>

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

} // namespace sedr
} // namespace pcl
